// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Right images against left images and depth: where a pixel must be seen, and whether it is.

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/scene_check/checks.h"

namespace cvo {

namespace {

// A slip in the pixel-centre convention shows as 0.5 px, one per cent of depth as 0.2 px at 20 px
// of disparity; interpolation and noise stay below 0.02 px.
constexpr double kShift_px = 0.05;
// Fewer pixels cannot distinguish such a shift from noise.
constexpr std::size_t kMinShiftPixels = 2000;
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

// By how much the right image is off where depth puts it; empty if too few pixels can tell.
// Compares the left image with what its camera would see with the pixels of the right one: one step
// of Gauss-Newton for the shift, a gain and an offset. Leaves out pixels at depth edges and, as the
// right camera may not see them, those that differ by more than three deviations.
std::optional<cv::Point2d> CompareSides(const SceneFolder& scene, int frame) {
  constexpr double kThreeDeviations = 3.0 * 1.4826, kLeastCut_grey = 3.0;
  const StereoCamera& camera = scene.sequence.camera;
  const StereoPaths& paths = scene.sequence.images[static_cast<std::size_t>(frame)];
  const Surface surface = {scene.Depth(frame), scene.Instances(frame)};
  cv::Mat left, right, du, dv;
  ReadGrey(paths.left).convertTo(left, CV_32F);
  ReadGrey(paths.right).convertTo(right, CV_32F);
  cv::Mat places(left.size(), CV_32FC2);
  for (int v = 0; v < left.rows; ++v) {
    for (int u = 0; u < left.cols; ++u) {
      const bool is_seen = surface.depth.at<float>(v, u) > 0.0F;
      const double u_right = is_seen ? u - DisparityAt(camera, surface.depth, u, v) : u;
      places.at<cv::Vec2f>(v, u) = {static_cast<float>(u_right), static_cast<float>(v)};
    }
  }
  cv::remap(right, right, places, {}, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
  // The mean gradient of both: the noise in the gradient of only one would bias the shift.
  constexpr double kPerPixel = 1.0 / 16.0;
  const cv::Mat both = left + right;
  cv::Sobel(both, du, CV_32F, 1, 0, 3, kPerPixel);
  cv::Sobel(both, dv, CV_32F, 0, 1, 3, kPerPixel);
  std::vector<cv::Vec4f> gradients;
  std::vector<float> differences;
  std::vector<double> sizes;
  for (int v = 1; v < left.rows; ++v) {
    for (int u = 1; u < left.cols; ++u) {
      if (!IsSmooth(camera, surface, u, v) || places.at<cv::Vec2f>(v, u)[0] < 1.0F) continue;
      const float grey = left.at<float>(v, u);
      gradients.emplace_back(-du.at<float>(v, u), -dv.at<float>(v, u), grey, 1.0F);
      differences.push_back(right.at<float>(v, u) - grey);
      sizes.push_back(std::abs(differences.back()));
    }
  }
  if (sizes.size() < kMinShiftPixels) return std::nullopt;
  const double cut = std::max(kLeastCut_grey, kThreeDeviations * Median(std::move(sizes)));
  std::size_t count = 0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (std::abs(differences[i]) > cut) continue;
    gradients[count] = gradients[i];
    differences[count++] = differences[i];
  }
  const int rows = static_cast<int>(count);
  cv::Vec4f x;
  cv::solve(cv::Mat(gradients).rowRange(0, rows).reshape(1), cv::Mat(differences).rowRange(0, rows),
            x, cv::DECOMP_NORMAL);
  return cv::Point2d(x[0], x[1]);
}

}  // namespace

Eigen::Vector3d PointAt(const StereoCamera& camera, const cv::Mat& depth, int u, int v) {
  const double z = depth.at<float>(v, u);
  return {(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z};
}

std::vector<SceneCheck> CheckStereo(const SceneFolder& scene, TaskPool& pool) {
  const std::vector<int>& frames = scene.image_frames;
  const auto shifts = ForAll<std::optional<cv::Point2d>>(
      static_cast<int>(frames.size()), pool,
      [&](int i) { return CompareSides(scene, frames[static_cast<std::size_t>(i)]); });
  Worst across, down;
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    if (!shifts[i]) continue;
    const std::string place = StrCat("frame ", frames[i]);
    across.Add(std::abs(shifts[i]->x), place);
    down.Add(std::abs(shifts[i]->y), place);
  }
  if (across.where.empty()) across.Add(std::nan(""), "all frames: too few pixels to compare");
  return {across.AtMost("disparity_offset", "px", kShift_px),
          down.AtMost("row_offset", "px", kShift_px)};
}

}  // namespace cvo
