// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/scene_check/reprojection.h"

#include <algorithm>
#include <cmath>

namespace cvo {
namespace {

// Neighbouring pixels on one surface differ by less than this in disparity, unless the surface is
// seen at a grazing angle.
constexpr double kSmooth_px = 0.3;

double DisparityAt(const StereoCamera& camera, const cv::Mat& depth, int u, int v) {
  return camera.fx * camera.baseline_m / depth.at<float>(v, u);
}

// Returns the largest disparity that lands on each column of the right image's row.
std::vector<double> NearestInRow(const StereoCamera& camera, const cv::Mat& depth, int v) {
  std::vector<double> nearest(static_cast<std::size_t>(depth.cols), 0.0);
  for (int u = 0; u < depth.cols; ++u) {
    if (!(depth.at<float>(v, u) > 0.0F)) continue;
    const double disparity_px = DisparityAt(camera, depth, u, v);
    const int column = static_cast<int>(std::floor(u - disparity_px));
    for (const int c : {column, column + 1}) {
      if (c < 0 || c >= depth.cols) continue;
      double& value = nearest[static_cast<std::size_t>(c)];
      value = std::max(value, disparity_px);
    }
  }
  return nearest;
}

bool IsSeenAt(const std::vector<double>& nearest, double column, double disparity_px) {
  constexpr double kMargin_px = 1.0;
  const int first = static_cast<int>(std::floor(column)) - 1;
  for (int c = first; c < first + 4; ++c) {
    if (c < 0 || c >= static_cast<int>(nearest.size())) continue;
    if (nearest[static_cast<std::size_t>(c)] > disparity_px + kMargin_px) return false;
  }
  return true;
}

}  // namespace

Eigen::Vector3d PointAt(const StereoCamera& camera, const cv::Mat& depth, int u, int v) {
  const double z = depth.at<float>(v, u);
  return {(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z};
}

bool IsSmooth(const StereoCamera& camera, const Surface& surface, int u, int v) {
  if (u < 1 || v < 1 || u + 1 >= surface.depth.cols || v + 1 >= surface.depth.rows) return false;
  const double disparity_px = DisparityAt(camera, surface.depth, u, v);
  const auto body = surface.instances.at<std::uint16_t>(v, u);
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      if (!(surface.depth.at<float>(v + dv, u + du) > 0.0F)) return false;
      if (surface.instances.at<std::uint16_t>(v + dv, u + du) != body) return false;
      const double other_px = DisparityAt(camera, surface.depth, u + du, v + dv);
      if (std::abs(other_px - disparity_px) > kSmooth_px) return false;
    }
  }
  return true;
}

std::vector<PixelPrediction> PredictRight(const StereoCamera& camera, const Surface& surface,
                                          int step) {
  std::vector<PixelPrediction> predictions;
  for (int v = 1; v < surface.depth.rows; v += step) {
    const std::vector<double> nearest = NearestInRow(camera, surface.depth, v);
    for (int u = 1; u < surface.depth.cols; u += step) {
      if (!(surface.depth.at<float>(v, u) > 0.0F)) continue;
      const double disparity_px = DisparityAt(camera, surface.depth, u, v);
      if (!IsSeenAt(nearest, u - disparity_px, disparity_px)) continue;
      if (!IsSmooth(camera, surface, u, v)) continue;
      predictions.push_back({u, v, u - disparity_px, static_cast<double>(v)});
    }
  }
  return predictions;
}

std::vector<PixelPrediction> PredictNext(const StereoCamera& camera, const Surface& surface,
                                         const Surface& next, int body,
                                         const RigidTransform& next_from_this, int step,
                                         std::vector<float>& depth_errors_px) {
  std::vector<PixelPrediction> predictions;
  const Eigen::Matrix3d R = next_from_this.RotationMatrix();
  const Eigen::Vector3d t = next_from_this.translation();
  for (int v = 1; v < surface.depth.rows; v += step) {
    for (int u = 1; u < surface.depth.cols; u += step) {
      if (surface.instances.at<std::uint16_t>(v, u) != body) continue;
      if (!(surface.depth.at<float>(v, u) > 0.0F)) continue;
      const Eigen::Vector3d moved = R * PointAt(camera, surface.depth, u, v) + t;
      const auto z_px = camera.Project(moved);
      if (!z_px || !camera.InImage((*z_px)[0], (*z_px)[1])) continue;
      const double disparity_px = (*z_px)[0] - (*z_px)[2];
      const int u0 = static_cast<int>((*z_px)[0]), v0 = static_cast<int>((*z_px)[1]);
      if (u0 + 1 >= next.depth.cols || v0 + 1 >= next.depth.rows) continue;
      if (!(next.depth.at<float>(v0, u0) > 0.0F)) continue;
      if (next.instances.at<std::uint16_t>(v0, u0) != body) continue;
      if (!IsSmooth(camera, surface, u, v) || !IsSmooth(camera, next, u0, v0)) continue;
      const double a = (*z_px)[0] - u0, b = (*z_px)[1] - v0;
      const auto at = [&](int du, int dv) {
        return DisparityAt(camera, next.depth, u0 + du, v0 + dv);
      };
      const double found_px =
          (1 - b) * ((1 - a) * at(0, 0) + a * at(1, 0)) + b * ((1 - a) * at(0, 1) + a * at(1, 1));
      // A larger difference means that another surface has come in front.
      constexpr double kSameSurface_px = 1.0;
      if (std::abs(found_px - disparity_px) > kSameSurface_px) continue;
      depth_errors_px.push_back(static_cast<float>(std::abs(found_px - disparity_px)));
      predictions.push_back({u, v, (*z_px)[0], (*z_px)[1]});
    }
  }
  return predictions;
}

}  // namespace cvo
