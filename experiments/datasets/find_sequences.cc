// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "experiments/datasets/sequence_type.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

bool IsFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool IsNumber(const std::string& name) {
  return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
}

// Folders in `folder`, sorted; none where it cannot be read.
std::vector<fs::path> SubFolders(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (IsFolder(entry.path())) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

bool HasBoth(const fs::path& folder, const char* left, const char* right, const fs::path& below) {
  return IsFolder(folder / left / below) && IsFolder(folder / right / below);
}

bool HoldsImages(const fs::path& folder, const std::string& type) {
  if (type == kKittiRaw) {
    return HasBoth(folder, "image_00", "image_01", "data") ||
           HasBoth(folder, "image_02", "image_03", "data");
  }
  if (type == kKittiOdometry) {
    return HasBoth(folder, "image_0", "image_1", "") || HasBoth(folder, "image_2", "image_3", "");
  }
  const fs::path parent = folder.parent_path();
  const bool in_images = parent.filename().string().starts_with("image_0");
  return HasBoth(in_images ? parent.parent_path() : parent, "image_02", "image_03",
                 folder.filename());
}

// Each folder once, so that circles of symbolic links end.
void Collect(const fs::path& folder, std::set<fs::path>& visited,
             std::vector<FoundSequence>& found) {
  std::error_code error;
  if (!visited.insert(fs::weakly_canonical(folder, error)).second) return;
  const std::string type = DetectSequenceType(folder);
  if (!type.empty()) {
    if (HoldsImages(folder, type)) found.push_back({folder, type});
    return;
  }
  if (IsTrackingSet(folder)) {
    for (const fs::path& number : TrackingSequences(folder)) {
      if (HoldsImages(number, kKittiTracking)) found.push_back({number, kKittiTracking});
    }
    return;
  }
  for (const fs::path& child : SubFolders(folder)) {
    if (!child.filename().string().starts_with('.')) Collect(child, visited, found);
  }
}

}  // namespace

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
  for (const char* image : {"image_00", "image_01", "image_02", "image_03"}) {
    if (IsFolder(folder / image / "data")) return kKittiRaw;
  }
  for (const char* image : {"image_0", "image_1", "image_2", "image_3"}) {
    if (IsFolder(folder / image)) return kKittiOdometry;
  }
  const fs::path number = folder.filename();
  if (!IsNumber(number.string())) return "";
  const fs::path parent = folder.parent_path();
  const bool in_images = parent.filename().string().starts_with("image_0");
  const fs::path set_folder = in_images ? parent.parent_path() : parent;
  const bool known = IsFolder(set_folder / "image_02" / number) ||
                     fs::exists(set_folder / "calib" / (number.string() + ".txt"));
  return IsTrackingSet(set_folder) && known ? kKittiTracking : "";
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
