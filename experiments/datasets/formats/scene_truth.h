// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/association/box_association.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// One body in one frame of a synthetic scene: a row of objects.csv. The world is the first left
// camera. The object's frame is x forward, y left, z up, with its origin at the centre of its box.
struct SceneBody {
  int id = 0;  // 1, 2, ...: the value in instance masks
  std::string name;
  std::string category;
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_in_world;          // of the object's origin, m/s
  Eigen::Vector3d angular_velocity_in_world;  // rad/s
  Eigen::Vector3d size_m;                     // of its box along x, y, z
  int visible_px = 0;                         // in the mask of the left image
  double visible_fraction = 0.0;              // of what is seen if nothing occludes it
  // Around the mask; empty if the mask is. All four sides lie on pixels of it.
  std::optional<ImageBox> visible_box;
};

extern const std::string_view kObjectsHeader;

// Reads objects.csv as [frame][id - 1]: every body in every frame, in this order. Names, categories
// and sizes must be the same in all frames. Throws Error with file and line.
std::vector<std::vector<SceneBody>> ReadSceneBodies(const std::filesystem::path& path,
                                                    int frame_count);

// Throw Error unless the file is complete and of the expected kind and size.
cv::Mat ReadDepth(const std::filesystem::path& path, cv::Size size);      // CV_32FC1, m; 0: nothing
cv::Mat ReadInstances(const std::filesystem::path& path, cv::Size size);  // CV_16UC1; 0: background

// How the rendered right camera differs from the calibration, as the scene's manifest tells.
struct RightCameraError {
  double shift_px = 0.0;                 // of the principal point
  std::array<double, 3> rotation_deg{};  // about its x, y, z axes
  double focal = 0.0;                    // relative

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("shift_px", self.shift_px);
    archive.Field("rotation_deg", self.rotation_deg);
    archive.Field("focal", self.focal);
  }
};

// Reads it from manifest.json; no difference if the manifest states none.
RightCameraError ReadRightCameraError(const std::filesystem::path& manifest);

}  // namespace cvo
