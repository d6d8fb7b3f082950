// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "experiments/scene_check/checks.h"
#include "experiments/scene_check/limits.h"

namespace cvo {
namespace {

struct CornerErrors {
  std::vector<Eigen::Vector2d> left;  // found - projected, px
  std::vector<Eigen::Vector2d> right;
  double worst_px = 0.0;
};

// Starts the search at whole pixels, so that the fractional part of the projection cannot leak into
// the result.
std::vector<Eigen::Vector2d> FindErrors(const cv::Mat& image,
                                        const std::vector<Eigen::Vector2d>& projected) {
  constexpr int kRadius_px = 7;  // squares must be twice as large
  std::vector<cv::Point2f> found;
  std::vector<Eigen::Vector2d> near;
  for (const Eigen::Vector2d& p : projected) {
    constexpr double kBorder_px = 2.0 * kRadius_px;
    if (p.x() < kBorder_px || p.y() < kBorder_px || p.x() > image.cols - 1 - kBorder_px ||
        p.y() > image.rows - 1 - kBorder_px) {
      continue;
    }
    near.push_back(p);
    found.emplace_back(static_cast<float>(std::round(p.x())),
                       static_cast<float>(std::round(p.y())));
  }
  if (found.empty()) return {};
  // On exact images with 64 rays per pixel, cornerSubPix alone has errors of up to 0.1 px (bilinear
  // samples distort sharp edges), and of up to 0.034 px after this blur, which does not move a
  // corner between four squares.
  cv::Mat smooth;
  cv::GaussianBlur(image, smooth, {}, 1.5);
  cv::cornerSubPix(smooth, found, {kRadius_px, kRadius_px}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 50, 1e-3});
  std::vector<Eigen::Vector2d> errors;
  for (std::size_t i = 0; i < found.size(); ++i) {
    errors.emplace_back(static_cast<double>(found[i].x) - near[i].x(),
                        static_cast<double>(found[i].y) - near[i].y());
  }
  return errors;
}

CornerErrors MeasureTarget(const SceneFolder& scene, int frame,
                           const std::vector<Eigen::Vector3d>& corners) {
  std::vector<Eigen::Vector2d> left, right;
  for (const Eigen::Vector3d& corner : corners) {
    const auto z_px = scene.sequence.camera.Project(corner);
    if (!z_px) continue;
    left.emplace_back((*z_px)[0], (*z_px)[1]);
    right.emplace_back((*z_px)[2], (*z_px)[1]);
  }
  CornerErrors errors;
  errors.left = FindErrors(ReadGrey(scene.FileOf("calibration/image_0", frame, ".png")), left);
  errors.right = FindErrors(ReadGrey(scene.FileOf("calibration/image_1", frame, ".png")), right);
  for (const auto* side : {&errors.left, &errors.right}) {
    for (const Eigen::Vector2d& error : *side) {
      errors.worst_px = std::max(errors.worst_px, error.norm());
    }
  }
  return errors;
}

struct MeanError {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;

  void Add(const std::vector<Eigen::Vector2d>& errors) {
    for (const Eigen::Vector2d& error : errors) sum += error;
    count += static_cast<int>(errors.size());
  }
  SceneCheck Check(const char* name) const {
    const Eigen::Vector2d mean = sum / std::max(count, 1);
    return {name,
            mean.norm(),
            "px",
            Bound::kAtMost,
            limits::kTargetCorner_px,
            StrCat("mean ", Short(mean.x()), ", ", Short(mean.y()))};
  }
};

}  // namespace

std::vector<SceneCheck> CheckTargets(const SceneFolder& scene, TaskPool& pool) {
  std::map<int, std::vector<Eigen::Vector3d>> corners;
  for (const TargetCorner& corner : ReadTargetCorners(scene.path / "calibration/targets.csv")) {
    corners[corner.frame].push_back(corner.p_in_left);
  }
  std::vector<int> frames;
  for (const auto& [frame, of_frame] : corners) frames.push_back(frame);
  const auto results = ForAll<CornerErrors>(static_cast<int>(frames.size()), pool, [&](int i) {
    const int frame = frames[static_cast<std::size_t>(i)];
    return MeasureTarget(scene, frame, corners.at(frame));
  });
  MeanError left, right;
  Worst worst;
  for (std::size_t i = 0; i < results.size(); ++i) {
    left.Add(results[i].left);
    right.Add(results[i].right);
    worst.Add(results[i].worst_px, StrCat("target ", frames[i]));
  }
  return {{"target_corners", static_cast<double>(left.count + right.count), "corners",
           Bound::kAtLeast, limits::kMinTargetCorners, ""},
          left.Check("target_offset_left"),
          right.Check("target_offset_right"),
          worst.AtMost("target_corner_worst", "px", limits::kTargetCorner_px)};
}

}  // namespace cvo
