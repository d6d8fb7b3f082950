// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cvo {

// One row of a KITTI label or detection file. Frames are counted from the start of the folder's
// sequence.
struct ObjectBox {
  int frame = 0;
  int track = -1;  // -1 if the file has none; never shown to the estimator
  std::string type;
  double truncation = -1.0;
  int occlusion = -1;
  double left_px = 0.0;
  double top_px = 0.0;
  double right_px = 0.0;
  double bottom_px = 0.0;
  // 3D box in rectified camera 0 (see Sequence::left_offset_m) if the file has one (labels):
  // height, width, length (m), centre of the bottom face (m), heading about the y axis (rad).
  struct Box3d {
    double height_m, width_m, length_m;
    Eigen::Vector3d bottom_in_camera;
    double heading_rad;
  };
  std::optional<Box3d> box3d;
  std::optional<double> score;

  // Whether it has a box in the image: trackers in 3D write -1 -1 -1 -1.
  bool IsInImage() const { return right_px > left_px && bottom_px > top_px; }
};

// Reads a KITTI tracking label file: 17 columns per row, or as ReadDetections, frames below
// `frame_count`. Throws Error with file and line, also for a track that a frame has twice.
std::vector<ObjectBox> ReadLabels(const std::filesystem::path& path, int frame_count);

// Reads a KITTI tracking result file: like a label file, with the score in the 18th column or in
// the last of 19 (files with one more value before it). Every row of a file has the same number of
// columns. Label files are accepted too, without scores.
std::vector<ObjectBox> ReadDetections(const std::filesystem::path& path, int frame_count);
// The same, for the tracks of a tracker: a frame has none twice, within a class.
std::vector<ObjectBox> ReadTracks(const std::filesystem::path& path, int frame_count);

// Reads a KITTI object file, which belongs to one image: 15 columns per row, or 16 with a score,
// the same number in every row.
std::vector<ObjectBox> ReadObjectFile(const std::filesystem::path& path, int frame);

// Returns the box as seen from a camera `offset_m` to the right of the given one: p_in_given =
// p_in_result + (offset_m, 0, 0). A point at depth z moves by -fx offset / z pixels in u. Throws
// Error unless depth_m > 0.
ObjectBox ShiftBox(const ObjectBox& box, double offset_m, double fx, double depth_m);

}  // namespace cvo
