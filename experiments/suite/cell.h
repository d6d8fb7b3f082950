// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/suite/suite.h"

namespace cvo {

// One run that a suite asks for, before anything is known of its input.
struct Cell {
  SuiteSequence sequence;
  std::string variant;  // of a system: empty
  std::string system;   // name of another system whose files are scored; empty: a variant
  std::uint64_t seed = 0;
  std::vector<std::pair<std::string, Json>> parameters;  // path and value, of the grid
  std::vector<std::string> oracle;
  bool landmarks = false;  // keeps every landmark; no part of what is computed
};

// Value by path.
Json ParametersOf(const Cell& cell);

// All cells, sequence by sequence, then seed, parameters, oracle, variant.
std::vector<Cell> ExpandSuite(const Suite& suite);

}  // namespace cvo
