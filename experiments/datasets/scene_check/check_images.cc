// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Right images against left images and depth: where a pixel must be seen, and whether it is.

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/scene_check/checks.h"

namespace cvo {

namespace {

// A slip of half a pixel in the pixel-centre convention shows as
// 0.5 px, an error of one per cent of depth as 0.2 px at 20 px of disparity; interpolation and
// noise stay below 0.02 px.
constexpr double kShift_px = 0.05;
// Fewer pixels cannot distinguish such a shift from noise.
constexpr int kMinShiftPixels = 2000;
// Reads an 8-bit image as grey. Throws Error if it cannot be decoded.
cv::Mat ReadGrey(const std::filesystem::path& path) {
  LoadedImage image = LoadGrey(path);
  if (!image.ok()) throw Error(image.problem);
  return image.grey;
}

// What the pixels of a left image show: depth in m (CV_32FC1) and body id (CV_16UC1).
struct Surface {
  cv::Mat depth;
  cv::Mat instances;
};

// Neighbouring pixels on one surface differ by less than this in disparity, unless the surface is
// seen at a grazing angle.
constexpr double kSmooth_px = 0.3;

double DisparityAt(const StereoCamera& camera, const cv::Mat& depth, int u, int v) {
  return camera.fx * camera.baseline_m / depth.at<float>(v, u);
}

// Whether (u, v) and its eight neighbours show one smooth surface of one body.
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

// Predicts the positions in the right image of pixels of the left one, taking every `step`-th pixel
// of every `step`-th row. Leaves out pixels at depth edges; those that the right camera cannot see
// differ in grey level and drop out of the estimate.
std::vector<PixelPrediction> PredictRight(const StereoCamera& camera, const Surface& surface,
                                          int step) {
  std::vector<PixelPrediction> predictions;
  for (int v = 1; v < surface.depth.rows; v += step) {
    for (int u = 1; u < surface.depth.cols; u += step) {
      if (!(surface.depth.at<float>(v, u) > 0.0F) || !IsSmooth(camera, surface, u, v)) continue;
      predictions.push_back(
          {u, v, u - DisparityAt(camera, surface.depth, u, v), static_cast<double>(v)});
    }
  }
  return predictions;
}

ImageShift CompareSides(const SceneFolder& scene, int frame) {
  constexpr int kStep = 2;
  const StereoPaths& paths = scene.sequence.images[static_cast<std::size_t>(frame)];
  const Surface surface = {scene.Depth(frame), scene.Instances(frame)};
  return EstimateShift(ReadGrey(paths.left), ReadGrey(paths.right),
                       PredictRight(scene.sequence.camera, surface, kStep));
}

}  // namespace

Eigen::Vector3d PointAt(const StereoCamera& camera, const cv::Mat& depth, int u, int v) {
  const double z = depth.at<float>(v, u);
  return {(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z};
}

std::vector<SceneCheck> CheckStereo(const SceneFolder& scene, TaskPool& pool) {
  const std::vector<int>& frames = scene.image_frames;
  const std::vector<ImageShift> shifts = ForAll<ImageShift>(
      static_cast<int>(frames.size()), pool,
      [&](int i) { return CompareSides(scene, frames[static_cast<std::size_t>(i)]); });
  Worst across, down;
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    if (shifts[i].pixels < kMinShiftPixels) continue;
    const std::string place = StrCat("frame ", frames[i]);
    across.Add(std::abs(shifts[i].shift_px.x()), place);
    down.Add(std::abs(shifts[i].shift_px.y()), place);
  }
  if (across.where.empty()) across.Add(std::nan(""), "all frames: too few pixels to compare");
  return {across.AtMost("disparity_offset", "px", kShift_px),
          down.AtMost("row_offset", "px", kShift_px)};
}

}  // namespace cvo
