// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cvo {

// Selects runs of a suite.
struct SuiteRunChoice {
  std::string folder;                      // output folder of the suite
  std::string sequence;                    // as the suite names it
  std::string variants;                    // separated by commas
  std::optional<std::uint64_t> seed = {};  // empty: the first in the plan
};

// Returns the folders of the selected runs, in the order of the variants. Throws Error for a
// variant that has no such run or whose run is not done. If several runs match (a grid), the first
// in the plan is taken.
std::vector<std::string> SuiteRunFolders(const SuiteRunChoice& choice);

}  // namespace cvo
