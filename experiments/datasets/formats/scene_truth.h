// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/record/csv_rows.h"

namespace cvo {

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
