// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/rng.h"
#include "core/features/orb/orb.h"
#include "core/features/stereo_matcher.h"
#include "core/geometry/stereo_camera.h"

namespace cvo::test {

// Synthetic images with known disparities. A scene consists of overlapping grey shapes ("dead
// leaves", whose statistics are close to those of natural images) on a grid kSubpixelSteps times
// finer than the pixels.
inline constexpr int kSubpixelSteps = 8;
inline constexpr int kMargin_px = 48;  // of the scene, right of the image, for disparities

inline cv::Mat DrawScene(int width_px, int height_px, std::uint64_t seed) {
  Rng rng(seed, "scene");
  cv::Mat scene(height_px * kSubpixelSteps, (width_px + kMargin_px) * kSubpixelSteps, CV_8UC1,
                cv::Scalar(128));
  const int shapes = scene.cols / kSubpixelSteps * height_px / 25;
  for (int i = 0; i < shapes; ++i) {
    const cv::Point2f centre(static_cast<float>(rng.Uniform(0.0, scene.cols)),
                             static_cast<float>(rng.Uniform(0.0, scene.rows)));
    const double radius_px = std::min(40.0, 2.0 / std::sqrt(1e-3 + rng.Uniform()));
    const float radius = static_cast<float>(radius_px * kSubpixelSteps);
    const cv::Scalar shade(20.0 + static_cast<double>(rng.UniformInt(216)));
    const float aspect = static_cast<float>(rng.Uniform(0.5, 2.0));
    const float angle = static_cast<float>(rng.Uniform(0.0, 180.0));
    cv::Point2f corners[4];
    cv::RotatedRect(centre, cv::Size2f(2.0F * radius, aspect * radius), angle).points(corners);
    cv::Point rounded[4];
    for (int k = 0; k < 4; ++k) rounded[k] = corners[k];
    cv::fillConvexPoly(scene, rounded, 4, shade);
  }
  cv::GaussianBlur(scene, scene, cv::Size(), 0.5 * kSubpixelSteps);  // blur of the lens
  return scene;
}

// Renders the image of a camera that shows the scene `fine_shift` fine pixels further to the right.
inline cv::Mat Render(const cv::Mat& scene, int fine_shift, double noise = 0.0,
                      std::uint64_t seed = 0) {
  Rng rng(seed, "noise");
  cv::Mat image(scene.rows / kSubpixelSteps, scene.cols / kSubpixelSteps - kMargin_px, CV_8UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      int sum = 0;
      for (int y = 0; y < kSubpixelSteps; ++y) {
        const std::uint8_t* row =
            scene.ptr<std::uint8_t>(v * kSubpixelSteps + y) + u * kSubpixelSteps + fine_shift;
        for (int x = 0; x < kSubpixelSteps; ++x) sum += row[x];
      }
      const double value =
          static_cast<double>(sum) / (kSubpixelSteps * kSubpixelSteps) + noise * rng.Normal();
      image.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(value);
    }
  }
  return image;
}

inline StereoCamera CameraFor(const cv::Mat& image) {
  StereoCamera camera;
  camera.fx = camera.fy = 700.0;
  camera.cx = 0.5 * (image.cols - 1);
  camera.cy = 0.5 * (image.rows - 1);
  camera.baseline_m = 0.5;
  camera.width_px = image.cols;
  camera.height_px = image.rows;
  return camera;
}

inline std::vector<StereoFeature> MatchImages(const cv::Mat& left, const cv::Mat& right,
                                              const StereoMatchOptions& options = {}) {
  const OrbOptions orb;
  return MatchStereo(ExtractOrb(left, orb), ExtractOrb(right, orb), CameraFor(left), orb, options);
}

inline double Disparity(const StereoFeature& feature) {
  return feature.z_px.x() - feature.z_px.z();
}

}  // namespace cvo::test
