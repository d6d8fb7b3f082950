// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/image_files.h"

#include <algorithm>
#include <map>
#include <string>

#include "core/base/error.h"
#include "core/files/number.h"
#include "experiments/datasets/png.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

bool IsJpeg(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".jpg" || extension == ".jpeg" || extension == ".JPG";
}

std::map<std::int64_t, fs::path> NumberedFiles(const fs::path& folder,
                                               const std::string& extension) {
  std::map<std::int64_t, fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if (extension == ".png" && IsJpeg(path)) {
      ThrowError(path.string(), "a JPEG image", "PNG images (JPEG changes pixels)");
    }
    const std::string stem = path.stem().string();
    if (path.extension() != extension ||
        stem.find_first_not_of("0123456789") != std::string::npos) {
      continue;
    }
    const std::optional<std::int64_t> number = ParseInteger(stem);
    if (!number) continue;
    const auto [same, added] = files.emplace(*number, path);
    if (!added) {
      const auto [first, second] = std::minmax(same->second, path);
      ThrowError(second.string(), StrCat("number ", *number, " a second time"),
                 StrCat("only ", first.filename().string()));
    }
  }
  return files;
}

// The name that a file of another number has in the same folder: equally many digits.
std::string SiblingName(const fs::path& sibling, std::int64_t number) {
  std::string digits = std::to_string(number);
  const std::size_t width = sibling.stem().string().size();
  if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
  return digits + sibling.extension().string();
}

void CheckNoGap(const fs::path& folder, const std::map<std::int64_t, fs::path>& files) {
  const std::int64_t last = files.rbegin()->first;
  const std::int64_t absent = last + 1 - static_cast<std::int64_t>(files.size());
  if (absent == 0) return;
  constexpr int kListed = 10;
  std::string names;
  int listed = 0;
  for (std::int64_t number = 0; number <= last && listed < kListed; ++number) {
    if (files.contains(number)) continue;
    names += (listed++ == 0 ? "" : ", ") + SiblingName(files.rbegin()->second, number);
  }
  if (absent > listed) names += StrCat(" and ", absent - listed, " more");
  ThrowError(folder.string(), StrCat(files.size(), " files without ", names),
             StrCat("all from ", SiblingName(files.rbegin()->second, 0), " to ",
                    files.rbegin()->second.filename().string()));
}

void CheckSize(const fs::path& path, const StereoImages& images, const fs::path& first) {
  const PngHeader header = ReadPngHeader(path);
  if (header.width_px == images.width_px && header.height_px == images.height_px) return;
  ThrowError(path.string(), StrCat(header.width_px, "x", header.height_px, " pixels"),
             StrCat(images.width_px, "x", images.height_px, " as in ", first.string()));
}

}  // namespace

std::vector<fs::path> ListNumberedFiles(const fs::path& folder, const std::string& extension) {
  if (!fs::is_directory(folder)) {
    ThrowError(folder.string(), "no such folder", "a folder of <number>" + extension);
  }
  const std::map<std::int64_t, fs::path> files = NumberedFiles(folder, extension);
  if (files.empty()) {
    ThrowError(folder.string(), StrCat("no <number>", extension), "at least one such file");
  }
  CheckNoGap(folder, files);
  std::vector<fs::path> paths;
  for (const auto& [number, path] : files) paths.push_back(path);
  return paths;
}

StereoImages ListStereoImages(const fs::path& left_folder, const fs::path& right_folder) {
  const std::vector<fs::path> left = ListNumberedFiles(left_folder, ".png");
  const std::vector<fs::path> right = ListNumberedFiles(right_folder, ".png");
  if (left.size() != right.size()) {
    ThrowError(right_folder.string(), StrCat(right.size(), " images"),
               StrCat(left.size(), ", as many as in ", left_folder.string()));
  }
  const PngHeader header = ReadPngHeader(left[0]);
  StereoImages images;
  images.width_px = header.width_px;
  images.height_px = header.height_px;
  for (std::size_t i = 0; i < left.size(); ++i) {
    CheckSize(left[i], images, left[0]);
    CheckSize(right[i], images, left[0]);
    images.paths.push_back({left[i], right[i]});
  }
  return images;
}

}  // namespace cvo
