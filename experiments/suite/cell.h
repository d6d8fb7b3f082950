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

// One run requested by a suite, before its input has been located.
struct Cell {
  SuiteSequence sequence;
  std::string variant;  // empty for another system
  std::string system;   // name of another system whose files are scored; empty for a variant
  std::uint64_t seed = 0;
  std::vector<std::pair<std::string, Json>> parameters;  // (path, value) of each grid axis
  std::vector<std::string> oracle;
  bool landmarks = false;  // record every landmark; does not affect what is computed
};

// Returns the cell's grid parameters as a JSON object, value by path.
Json ParametersOf(const Cell& cell);

// Returns all cells, ordered by sequence, then seed, parameters, oracle and variant.
std::vector<Cell> ExpandSuite(const Suite& suite);

}  // namespace cvo
