// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/pose_format.h"

#include <sstream>

#include "core/base/error.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

// Before the first word that starts a comment.
int CountColumns(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  int columns = 0;
  while (words >> word && !word.starts_with('#')) ++columns;
  return columns;
}

}  // namespace

std::string DetectPoseFormat(const std::filesystem::path& path) {
  const TextFile file(path);
  for (std::size_t i = 0; i < file.size(); ++i) {
    const int columns = CountColumns(file.line(i));
    if (columns == 0) continue;
    if (columns == 8) return "tum";
    if (columns == 12) return "kitti";
    ThrowError(file.Where(i), StrCat(columns, " columns"),
               "8 (TUM: time tx ty tz qx qy qz qw) or 12 (KITTI: rows of [R t])");
  }
  ThrowError(path.string(), "no pose", "a TUM or KITTI trajectory");
}

std::string WhereTumPose(const std::filesystem::path& path, std::size_t index) {
  const TextFile file(path);
  for (std::size_t i = 0; i < file.size(); ++i) {
    if (CountColumns(file.line(i)) == 0) continue;
    if (index == 0) return file.Where(i);
    --index;
  }
  throw Error(path.string() + ": no such pose");
}

}  // namespace cvo
