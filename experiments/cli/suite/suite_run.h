// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cvo {

// Which runs of a suite are meant.
struct SuiteRunChoice {
  std::string folder;                      // that the suite was run to
  std::string sequence;                    // as the suite names it
  std::string variants;                    // with commas between
  std::optional<std::uint64_t> seed = {};  // empty: the first
};

// Their folders, in the order of the variants. Throws Error for a variant of which there is no such
// run, or whose run is not done; of several (a grid) the first of the plan is taken.
std::vector<std::string> SuiteRunFolders(const SuiteRunChoice& choice);

}  // namespace cvo
