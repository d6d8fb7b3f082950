// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/plan/data_folder.h"

#include "core/base/error.h"
#include "core/files/text/closest_names.h"
#include "experiments/datasets/sequence_type.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Whether the last components of `path` are those of `end`.
bool EndsWith(const fs::path& path, const fs::path& end) {
  auto a = path.end();
  auto b = end.end();
  while (b != end.begin()) {
    if (a == path.begin() || *--a != *--b) return false;
  }
  return true;
}

// Returns as many of the last components of `path` as `other` has.
std::string LastParts(const fs::path& path, const fs::path& other) {
  fs::path last;
  auto part = path.end();
  for (auto i = other.begin(); i != other.end() && part != path.begin(); ++i) last = *--part / last;
  return NormalFolder(fs::path("/") / last).relative_path().string();
}

}  // namespace

const std::vector<FoundSequence>& DataFolder::All() {
  if (!all_) all_ = FindSequences(root_);
  return *all_;
}

DataFolder::Found DataFolder::Find(const std::string& folder) {
  if (root_.empty()) return {{}, "no data folder: use --data or set CLUSTERVO_DATA"};
  std::error_code ignored;
  if (!fs::is_directory(root_, ignored)) return {{}, "no data folder " + root_.string()};
  const fs::path direct = NormalFolder(root_ / folder);
  if (!DetectSequenceType(direct).empty()) {
    if (HasImages(direct)) return {fs::absolute(direct), ""};
    return {{}, StrCat("no images of both cameras of ", folder, " below ", root_.string())};
  }
  Found found;
  for (const FoundSequence& sequence : All()) {
    if (!EndsWith(sequence.folder, NormalFolder(fs::path("/") / folder).relative_path())) continue;
    if (!found.folder.empty()) {
      return {{},
              StrCat("both ", found.folder.string(), " and ", sequence.folder.string(), " end in ",
                     folder)};
    }
    found.folder = fs::absolute(sequence.folder);
  }
  if (found.folder.empty()) {
    std::vector<std::string> known;
    for (const FoundSequence& sequence : All()) {
      known.push_back(LastParts(sequence.folder, fs::path(folder)));
    }
    found.missing = StrCat("no ", folder, DidYouMean(folder, known), " below ", root_.string());
  }
  return found;
}

}  // namespace cvo
