// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/suite/suite.h"

namespace cvo {

// What a command line changes of a suite: --seeds N (1 to N; 0: as the suite says), --frames and
// --set PATH=VALUE. A path of the suite's grid takes that one value; "scene.PATH" is of every
// scene; others are options. Throws Error for what the suite cannot have.
struct SuiteOverrides {
  int seeds = 0;
  std::vector<std::string> set;
  std::string frames = {};  // "A:B", of every sequence; empty: as the suite says
};
Suite Override(Suite suite, const SuiteOverrides& overrides);

}  // namespace cvo
