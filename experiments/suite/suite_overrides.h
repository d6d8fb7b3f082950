// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/suite/suite.h"

namespace cvo {

// Changes made to a suite on the command line: --seeds N (seeds 1 to N; 0: the suite's own),
// --frames and --set PATH=VALUE. A path in the suite's grid takes only the given value;
// "scene.PATH" and "perturb.PATH" apply to every sequence; any other path is an estimator option.
// Override throws Error for changes that the suite does not allow.
struct SuiteOverrides {
  int seeds = 0;
  std::vector<std::string> set;
  std::string frames = {};  // "A:B", for every sequence; empty: the suite's own
};
Suite Override(Suite suite, const SuiteOverrides& overrides);

}  // namespace cvo
