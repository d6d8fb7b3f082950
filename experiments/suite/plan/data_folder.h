// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

// The user's data folder. Sequences are found by their path below it, or by the end of their path.
class DataFolder {
 public:
  // An empty `root` means that there is no data folder. The folder is searched on first need.
  explicit DataFolder(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }

  struct Found {
    std::filesystem::path folder;  // absolute; empty: missing
    std::string missing;           // why it is missing, for the user
  };
  Found Find(const std::string& folder);

 private:
  const std::vector<FoundSequence>& All();

  std::filesystem::path root_;
  std::optional<std::vector<FoundSequence>> all_;
};

}  // namespace cvo
