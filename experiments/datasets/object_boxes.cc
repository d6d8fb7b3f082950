// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/object_boxes.h"

#include "core/base/error.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

constexpr std::size_t kLabelColumns = 17;
constexpr std::size_t kMaxDetectionColumns = 19;

// frame track type truncation occlusion alpha left top right bottom height width length x y z ry
ObjectBox ReadBox(const TextRow& row, int frame_count) {
  ObjectBox box;
  box.frame = row.Integer(0);
  if (box.frame < 0 || box.frame >= frame_count) {
    row.Fail(StrCat("frame ", box.frame),
             StrCat("a frame of the sequence, 0 to ", frame_count - 1));
  }
  box.track = row.Integer(1);
  box.type = std::string(row.Text(2));
  box.truncation = row.Number(3);
  box.occlusion = row.Integer(4);
  row.Number(5);
  box.left_px = row.Number(6);
  box.top_px = row.Number(7);
  box.right_px = row.Number(8);
  box.bottom_px = row.Number(9);
  if (box.right_px < box.left_px || box.bottom_px < box.top_px) {
    row.Fail(StrCat("a box of ", box.right_px - box.left_px, " x ", box.bottom_px - box.top_px,
                    " pixels"),
             "left <= right and top <= bottom");
  }
  const ObjectBox::Box3d box3d = {row.Number(10),
                                  row.Number(11),
                                  row.Number(12),
                                  {row.Number(13), row.Number(14), row.Number(15)},
                                  row.Number(16)};
  if (box3d.height_m > 0.0 && box3d.width_m > 0.0 && box3d.length_m > 0.0) box.box3d = box3d;
  for (std::size_t i = kLabelColumns; i < row.size(); ++i) box.score = row.Number(i);
  return box;
}

}  // namespace

std::vector<ObjectBox> ReadLabels(const std::filesystem::path& path, int frame_count) {
  const TextFile file(path);
  std::vector<ObjectBox> boxes;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i);
    row.ExpectColumns(kLabelColumns, "a KITTI tracking label");
    boxes.push_back(ReadBox(row, frame_count));
  }
  return boxes;
}

std::vector<ObjectBox> ReadDetections(const std::filesystem::path& path, int frame_count) {
  const TextFile file(path);
  std::vector<ObjectBox> boxes;
  std::size_t columns = 0;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i);
    if (i == 0) {
      columns = row.size();
      if (columns < kLabelColumns || columns > kMaxDetectionColumns) {
        row.ExpectColumns(kLabelColumns + 1, "a KITTI tracking result");
      }
    }
    row.ExpectColumns(columns, "as in the first line");
    boxes.push_back(ReadBox(row, frame_count));
  }
  return boxes;
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
