// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Images against depth, poses and masks: where the pixels of one image must be seen in another, and
// whether they are.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/scene_check/checks.h"

namespace cvo {

namespace {

// Images against depth and poses. A slip of half a pixel in the pixel-centre convention shows as
// 0.5 px, an error of one per cent of depth as 0.2 px at 20 px of disparity; interpolation and
// noise stay below 0.02 px.
constexpr double kShift_px = 0.05;
// For a single pair of consecutive frames, where shadows that move over the background count too.
// All frames together would hide a single wrong pose, as the errors of its two steps cancel.
constexpr double kFrameShift_px = 0.1;
// Fewer pixels cannot distinguish such a shift from noise.
constexpr int kMinShiftPixels = 2000;
// A shift with a larger standard deviation, as that of a small or plain body, is not evaluated.
constexpr double kMaxShiftSigma_px = 0.01;
// Residuals relative to the noise of the difference of two images; interpolated edges add to the
// noise. The grey levels are an allowance for interpolation, without which a scene free of noise
// would fail.
constexpr double kMedianResidual_sigmas = 2.0;
constexpr double kInterpolation_grey = 1.5;
// The light does not turn with a body: the shade of a ball that rolls at 0.8 m/s changes by some
// grey levels from frame to frame. A wrong rotation leaves residuals of 20 and more.
constexpr double kShading_grey = 6.0;
// Depth moved to the next frame, compared with that frame's depth, as disparity. Exact on planes
// except for 32-bit rounding.
constexpr double kDepthMotion_px = 0.01;

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
// of every `step`-th row. Leaves out pixels at depth edges and those hidden from the right camera.
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

// Predicts the positions in the next frame of the pixels of one body (0: background), which moves
// by next_from_this from the one left camera to the other. Appends to `depth_errors_px`, for each
// prediction, the absolute difference between predicted and actual depth, as a disparity.
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

struct FrameStereo {
  ImageShift shift;
  double noise = 0.0;  // grey levels, of the difference of both images
  double median = 0.0;
};

FrameStereo CompareSides(const SceneFolder& scene, int frame) {
  constexpr int kStep = 2;
  const StereoPaths& paths = scene.sequence.images[static_cast<std::size_t>(frame)];
  const cv::Mat left = ReadGrey(paths.left);
  const cv::Mat right = ReadGrey(paths.right);
  const Surface surface = {scene.Depth(frame), scene.Instances(frame)};
  FrameStereo result;
  result.shift = EstimateShift(left, right, PredictRight(scene.sequence.camera, surface, kStep));
  result.noise = std::hypot(EstimateNoise(left), EstimateNoise(right));
  const std::vector<float> residuals = std::exchange(result.shift.residuals, {});
  if (!residuals.empty()) result.median = residuals[residuals.size() / 2];
  return result;
}

SceneCheck Pooled(const char* name, double shift_px) {
  return {name, std::abs(shift_px), "px", Bound::kAtMost, kShift_px, "all frames together"};
}

// The motion of one body (0: background) from a frame to the next one.
struct BodyMotion {
  int body = 0;
  int frame = 0;
  ImageShift shift;
  double median_depth_error_px = 0.0;
  double median_residual = 0.0;  // grey levels
  double noise = 0.0;            // grey levels, of the difference of both images
};

RigidTransform RelativeMotion(const SceneFolder& scene, int frame, int body) {
  const auto i = static_cast<std::size_t>(frame);
  const RigidTransform left_from_world = scene.world_from_left[i + 1].Inverse();
  if (body == 0) return left_from_world * scene.world_from_left[i];
  const auto index = static_cast<std::size_t>(body) - 1;
  return left_from_world * scene.bodies[i + 1][index].world_from_object *
         scene.bodies[i][index].world_from_object.Inverse() * scene.world_from_left[i];
}

std::vector<BodyMotion> CompareFrames(const SceneFolder& scene, int frame) {
  const auto i = static_cast<std::size_t>(frame);
  const cv::Mat image = ReadGrey(scene.sequence.images[i].left);
  const cv::Mat next_image = ReadGrey(scene.sequence.images[i + 1].left);
  const Surface surface = {scene.Depth(frame), scene.Instances(frame)};
  const Surface next = {scene.Depth(frame + 1), scene.Instances(frame + 1)};
  const double noise = std::hypot(EstimateNoise(image), EstimateNoise(next_image));
  std::vector<BodyMotion> motions;
  for (int body = 0; body <= static_cast<int>(scene.bodies[i].size()); ++body) {
    std::vector<float> depth_errors;
    const std::vector<PixelPrediction> predictions =
        PredictNext(scene.sequence.camera, surface, next, body, RelativeMotion(scene, frame, body),
                    body == 0 ? 2 : 1, depth_errors);
    if (static_cast<int>(predictions.size()) < kMinShiftPixels) continue;
    ImageShift shift = EstimateShift(image, next_image, predictions);
    const double residual = MedianOf(shift.residuals);
    shift.residuals.clear();
    motions.push_back({body, frame, std::move(shift), MedianOf(depth_errors), residual, noise});
  }
  return motions;
}

std::string NameOf(const SceneFolder& scene, int body) {
  return body == 0 ? "background" : scene.bodies[0][static_cast<std::size_t>(body) - 1].name;
}

}  // namespace

Eigen::Vector3d PointAt(const StereoCamera& camera, const cv::Mat& depth, int u, int v) {
  const double z = depth.at<float>(v, u);
  return {(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z};
}

std::vector<SceneCheck> CheckStereo(const SceneFolder& scene, TaskPool& pool) {
  const std::vector<int>& frames = scene.image_frames;
  const std::vector<FrameStereo> results = ForAll<FrameStereo>(
      static_cast<int>(frames.size()), pool,
      [&](int i) { return CompareSides(scene, frames[static_cast<std::size_t>(i)]); });

  Worst across, down, median;
  std::vector<ImageShift> shifts;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const FrameStereo& result = results[i];
    const std::string place = StrCat("frame ", frames[i]);
    shifts.push_back(result.shift);
    // As a fraction of the allowed residual, which depends on the noise.
    median.Add(result.median / (kMedianResidual_sigmas * result.noise + kInterpolation_grey),
               StrCat(place, ": ", FormatGeneral(result.median, 3), " grey levels"));
    if (result.shift.pixels < kMinShiftPixels) continue;
    across.Add(std::abs(result.shift.shift_px.x()), place);
    down.Add(std::abs(result.shift.shift_px.y()), place);
  }
  const ImageShift pooled = PoolShifts(shifts);
  return {{"stereo_pixels", static_cast<double>(pooled.pixels), "px", Bound::kAtLeast,
           kMinShiftPixels, ""},
          median.AtMost("stereo_residual_median", "of allowed", 1.0),
          Pooled("disparity_offset", pooled.shift_px.x()),
          Pooled("row_offset", pooled.shift_px.y()),
          across.AtMost("disparity_offset_worst", "px", kShift_px),
          down.AtMost("row_offset_worst", "px", kShift_px)};
}

std::vector<SceneCheck> CheckMotion(const SceneFolder& scene, TaskPool& pool) {
  std::vector<int> frames = scene.image_frames;
  std::erase(frames, scene.frame_count() - 1);
  const auto results = ForAll<std::vector<BodyMotion>>(
      static_cast<int>(frames.size()), pool,
      [&](int i) { return CompareFrames(scene, frames[static_cast<std::size_t>(i)]); });

  Worst depths, background_shift, background_residual, body_residual;
  std::map<int, std::vector<ImageShift>> shifts;
  for (const std::vector<BodyMotion>& motions : results) {
    for (const BodyMotion& motion : motions) {
      const std::string place = StrCat(NameOf(scene, motion.body), ", frame ", motion.frame);
      depths.Add(motion.median_depth_error_px, place);
      shifts[motion.body].push_back(motion.shift);
      const bool background = motion.body == 0;
      if (background) background_shift.Add(motion.shift.shift_px.norm(), place);
      const double allowed = kMedianResidual_sigmas * motion.noise +
                             (background ? kInterpolation_grey : kShading_grey);
      (background ? background_residual : body_residual)
          .Add(motion.median_residual / allowed,
               StrCat(place, ": ", FormatGeneral(motion.median_residual, 3), " grey levels"));
    }
  }
  Worst bodies;
  ImageShift background;
  for (const auto& [body, of_body] : shifts) {
    const ImageShift pooled = PoolShifts(of_body);
    if (body == 0) background = pooled;
    if (body == 0 || pooled.MaxSigma_px() > kMaxShiftSigma_px) continue;
    bodies.Add(pooled.shift_px.norm(), NameOf(scene, body));
  }
  return {depths.AtMost("motion_depth", "px", kDepthMotion_px),
          {"motion_shift_background", background.shift_px.norm(), "px", Bound::kAtMost, kShift_px,
           "all frames together"},
          background_shift.AtMost("motion_shift_background_worst", "px", kFrameShift_px),
          background_residual.AtMost("motion_residual_background", "of allowed", 1.0),
          bodies.AtMost("motion_shift_bodies", "px", kShift_px),
          body_residual.AtMost("motion_residual_bodies", "of allowed", 1.0)};
}

}  // namespace cvo
