// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "synth/render/renderer.h"
#include "synth/scene/world.h"

namespace cvo::synth {

// Ground truth of one body in one frame. Transforms are in the scene's world.
struct BodyTruth {
  int id = 0;
  MotionState state;
  int visible_px = 0;                   // pixels in the mask
  int alone_px = 0;                     // pixels if nothing occluded it
  double visible_fraction = 0.0;        // visible_px / alone_px; 0 if out of view
  double truncation = 1.0;              // fraction of its projected box outside the image
  std::optional<ImageBox> visible_box;  // around the mask
  std::optional<ImageBox> amodal_box;   // around the projection of the whole body, within the image
};

struct FrameTruth {
  int frame = 0;  // in the scene
  double time_s = 0.0;
  RigidTransform world_from_left;
  std::vector<BodyTruth> bodies;  // [id - 1], all bodies of the scene
};

FrameTruth ComputeTruth(const World& world, int frame, const Rendering& rendering);

// Bounding box of triangles projected into the left image, as far as they are in front of the near
// plane (StereoCamera::kMinDepth_m). It is not clipped to the image.
class ProjectedBox {
 public:
  explicit ProjectedBox(const StereoCamera& rig) : rig_(rig) {}

  void Add(const Mesh& mesh, const RigidTransform& camera_from_mesh);
  [[nodiscard]] const std::optional<ImageBox>& box() const { return box_; }

 private:
  void AddPoint(const Eigen::Vector3d& p_in_camera);

  StereoCamera rig_;
  std::optional<ImageBox> box_;
};

// Formats the KITTI tracking labels of one frame, one line for each body with an amodal box: frame,
// track id (body id), type (category), truncation, occlusion (0: at least 0.8 visible, 1: at least
// 0.3, 2: less, 3: nothing), alpha, amodal box, height, width, length, bottom centre of its 3D box
// in the left camera's frame, heading about the camera's y axis. `row_frame` is the frame number to
// write.
std::string FormatLabels(const World& world, const FrameTruth& truth, int row_frame);

// Formats a line of a KITTI pose file: the upper 3x4 of the transform, in the shortest decimals
// that read back exactly.
std::string FormatKittiPose(const RigidTransform& world_from_camera);

// Formats calib.txt of KITTI odometry; cameras 2 and 3 repeat 0 and 1.
std::string FormatKittiCalibration(const StereoCamera& rig);

// Formats 7 as "000007", as in KITTI's file names.
std::string SixDigits(int number);

// objects.csv: a header, then one row per body and frame, whether the body is visible or not. Poses
// and velocities are in the world frame of the folder, its first left camera. The columns of a
// missing box are empty.
std::string ObjectTableHeader();
std::string FormatObjectRows(const World& world, const FrameTruth& truth, int row_frame,
                             const RigidTransform& first_left_from_world);

// The content of objects.csv. In `frames`, the world frame is the folder's first left camera and
// frame numbers count from 0. Only the camera's pose is not set.
struct ObjectTable {
  std::vector<std::string> categories;  // [id - 1]
  std::vector<Eigen::Vector3d> sizes_m;
  std::vector<FrameTruth> frames;
};

// `times_s` are the times of the folder's frames. Throws Error naming file and line.
ObjectTable ReadObjectTable(const std::filesystem::path& file, const std::vector<double>& times_s);

}  // namespace cvo::synth
