// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "experiments/datasets/sequence_layout.h"
#include "experiments/datasets/sequence_type.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

bool IsNumber(const std::string& name) {
  return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
}

// Returns the folders in `folder`, sorted; none if it cannot be read.
std::vector<fs::path> SubFolders(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (IsFolder(entry.path())) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

const SequenceLayout* LayoutOf(const fs::path& folder) {
  for (const SequenceLayout& layout : SequenceLayouts()) {
    if (layout.knows(folder)) return &layout;
  }
  return nullptr;
}

// Visits each folder once, so that cycles of symbolic links end.
void Collect(const fs::path& folder, std::set<fs::path>& visited,
             std::vector<FoundSequence>& found) {
  std::error_code error;
  if (!visited.insert(fs::weakly_canonical(folder, error)).second) return;
  if (const SequenceLayout* layout = LayoutOf(folder)) {
    if (layout->has_images(folder)) found.push_back({folder, layout->type});
    return;
  }
  if (IsTrackingSet(folder)) {
    for (const fs::path& number : TrackingSequences(folder)) {
      const SequenceLayout* layout = LayoutOf(number);
      if (layout != nullptr && layout->has_images(number)) found.push_back({number, layout->type});
    }
    return;
  }
  for (const fs::path& child : SubFolders(folder)) {
    if (!child.filename().string().starts_with('.')) Collect(child, visited, found);
  }
}

}  // namespace

bool IsFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool AreFolders(const fs::path& left, const fs::path& right) {
  return IsFolder(left) && IsFolder(right);
}

bool HasImages(const fs::path& folder) {
  const SequenceLayout* layout = LayoutOf(folder);
  return layout != nullptr && layout->has_images(folder);
}

bool IsTrackingSet(const fs::path& folder) {
  if (!IsFolder(folder / "calib")) return false;
  return IsFolder(folder / "image_02") || IsFolder(folder / "image_03");
}

std::vector<fs::path> TrackingSequences(const fs::path& set_folder) {
  std::vector<fs::path> sequences;
  for (const fs::path& images : SubFolders(set_folder / "image_02")) {
    if (IsNumber(images.filename().string())) sequences.push_back(set_folder / images.filename());
  }
  return sequences;
}

std::string DetectSequenceType(const fs::path& folder) {
  const SequenceLayout* layout = LayoutOf(folder);
  return layout == nullptr ? "" : layout->type;
}

std::vector<FoundSequence> FindSequences(const fs::path& root) {
  const fs::path folder = NormalFolder(root);
  std::vector<FoundSequence> found;
  std::set<fs::path> visited;
  Collect(folder, visited, found);
  if (found.empty() && !fs::exists(folder)) {
    ThrowError(root.string(), "no such folder", "a folder to look for sequences in");
  }
  std::sort(found.begin(), found.end(),
            [](const FoundSequence& a, const FoundSequence& b) { return a.folder < b.folder; });
  return found;
}

}  // namespace cvo
