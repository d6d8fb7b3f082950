// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/object_boxes.h"

#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/files/text_file.h"

namespace cvo {

namespace {

constexpr std::size_t kLabelColumns = 17;
constexpr std::size_t kObjectColumns = 15;
constexpr std::size_t kMaxDetectionColumns = 19;

// Columns from `first` on: type truncation occlusion alpha left top right bottom height width
// length x y z ry [score].
ObjectBox ReadObject(const TextRow& row, std::size_t first) {
  ObjectBox box;
  box.type = std::string(row.Text(first));
  box.truncation = row.Number(first + 1);
  box.occlusion = row.Integer(first + 2);
  row.Number(first + 3);
  box.left_px = row.Number(first + 4);
  box.top_px = row.Number(first + 5);
  box.right_px = row.Number(first + 6);
  box.bottom_px = row.Number(first + 7);
  if (box.right_px < box.left_px || box.bottom_px < box.top_px) {
    row.Fail(StrCat("a box of ", box.right_px - box.left_px, " x ", box.bottom_px - box.top_px,
                    " pixels"),
             "left <= right and top <= bottom");
  }
  const ObjectBox::Box3d box3d = {
      row.Number(first + 8),
      row.Number(first + 9),
      row.Number(first + 10),
      {row.Number(first + 11), row.Number(first + 12), row.Number(first + 13)},
      row.Number(first + 14)};
  const double least_m = std::min({box3d.height_m, box3d.width_m, box3d.length_m});
  constexpr double kUnknown = -1.0;
  if (least_m > 0.0) {
    box.box3d = box3d;
  } else if (least_m != kUnknown && box3d.bottom_in_camera.z() > 0.0) {
    row.Fail(StrCat("a body of ", least_m, " m in view"), "a size above 0, or -1: unknown");
  }
  for (std::size_t i = first + kObjectColumns; i < row.size(); ++i) box.score = row.Number(i);
  return box;
}

// Columns: frame, track, then those of an object.
ObjectBox ReadBox(const TextRow& row, int frame_count) {
  const int frame = row.Integer(0);
  if (frame < 0 || frame >= frame_count) {
    row.Fail(StrCat("frame ", frame), StrCat("a frame of the sequence, 0 to ", frame_count - 1));
  }
  ObjectBox box = ReadObject(row, kLabelColumns - kObjectColumns);
  box.frame = frame;
  box.track = row.Integer(1);
  return box;
}

[[noreturn]] void FailTwice(const TextRow& row, const ObjectBox& box) {
  row.Fail(StrCat("track ", box.track, " of frame ", box.frame, " a second time"), "each once");
}

// Reads rows of between `least` and `most` columns, the same number in each row.
template <typename Read>
std::vector<ObjectBox> ReadRows(const std::filesystem::path& path, std::size_t least,
                                std::size_t most, const char* what, const Read& read) {
  const TextFile file(path);
  std::vector<ObjectBox> boxes;
  std::size_t columns = 0;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i);
    if (i == 0) {
      columns = row.size();
      if (columns < least || columns > most) row.ExpectColumns(least + 1, what);
    }
    row.ExpectColumns(columns, "as in the first line");
    boxes.push_back(read(row));
  }
  return boxes;
}

}  // namespace

std::vector<ObjectBox> ReadLabels(const std::filesystem::path& path, int frame_count) {
  std::set<std::pair<int, int>> seen;
  return ReadRows(path, kLabelColumns, kMaxDetectionColumns, "a KITTI tracking label",
                  [&](const TextRow& row) {
                    ObjectBox box = ReadBox(row, frame_count);
                    // A negative track is not an object.
                    const bool twice = box.track >= 0 && !seen.emplace(box.frame, box.track).second;
                    if (twice) FailTwice(row, box);
                    return box;
                  });
}

std::vector<ObjectBox> ReadDetections(const std::filesystem::path& path, int frame_count) {
  return ReadRows(path, kLabelColumns, kMaxDetectionColumns, "a KITTI tracking result",
                  [&](const TextRow& row) { return ReadBox(row, frame_count); });
}

std::vector<ObjectBox> ReadTracks(const std::filesystem::path& path, int frame_count) {
  std::set<std::tuple<int, int, std::string>> seen;
  return ReadRows(path, kLabelColumns, kMaxDetectionColumns, "a KITTI tracking result",
                  [&](const TextRow& row) {
                    ObjectBox box = ReadBox(row, frame_count);
                    if (!seen.emplace(box.frame, box.track, box.type).second) FailTwice(row, box);
                    return box;
                  });
}

std::vector<ObjectBox> ReadObjectFile(const std::filesystem::path& path, int frame) {
  return ReadRows(path, kObjectColumns, kObjectColumns + 1, "a KITTI object",
                  [&](const TextRow& row) {
                    ObjectBox box = ReadObject(row, 0);
                    box.frame = frame;
                    return box;
                  });
}

ObjectBox ShiftBox(const ObjectBox& box, double offset_m, double fx, double depth_m) {
  Require(depth_m > 0.0, "ShiftBox: the depth must be positive");
  ObjectBox shifted = box;
  const double shift_px = -fx * offset_m / depth_m;
  shifted.left_px += shift_px;
  shifted.right_px += shift_px;
  return shifted;
}

}  // namespace cvo
