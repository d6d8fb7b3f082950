// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "experiments/metrics/object_truth.h"

namespace cvo {

// A body whose poses a data set states.
struct BodyTrack {
  int id = 0;      // 1, 2, ...
  int track = -1;  // its number in the labels; -1: none
  std::string name;
  std::string category;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // of a box around its origin, along its axes
  std::vector<std::optional<BodyFrame>> frames;      // of the folder
};

// A pixel of the left image that is known to show a body, or 0, the static scene.
struct LabelledPixel {
  Eigen::Vector2d at_px;
  int body = 0;
};

// All bodies of a sequence, in the world of the camera's truth, and what tells which of them a
// pixel shows: a mask, labelled pixels, or nothing. Frames are those of the folder.
struct BodyTracks {
  reports::TruthSource truth = reports::TruthSource::kOfficial;
  reports::Visibility visible;
  double mover_travel_m = 0.2;
  std::vector<BodyTrack> bodies;           // by id
  std::function<cv::Mat(int frame)> mask;  // CV_16UC1 of ids, 0 the static scene; may be empty
  std::vector<std::vector<LabelledPixel>> pixels;  // [frame]; may be empty
};

}  // namespace cvo
