// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "experiments/scene_check/checks.h"
#include "experiments/scene_check/image_shift.h"
#include "experiments/scene_check/limits.h"
#include "experiments/scene_check/reprojection.h"

namespace cvo {
namespace {

struct FrameStereo {
  ImageShift shift;
  double noise = 0.0;  // grey levels, of the difference of both images
  double median = 0.0;
  double tail = 0.0;  // 90th percentile
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
  std::vector<float> residuals = std::move(result.shift.residuals);
  result.shift.residuals.clear();
  if (residuals.empty()) return result;
  result.median = residuals[residuals.size() / 2];
  result.tail = residuals[residuals.size() * 9 / 10];
  return result;
}

SceneCheck Pooled(const char* name, double shift_px) {
  return {name, std::abs(shift_px), "px", Bound::kAtMost, limits::kShift_px, "all frames together"};
}

}  // namespace

std::vector<SceneCheck> CheckStereo(const SceneFolder& scene, TaskPool& pool) {
  const std::vector<int>& frames = scene.image_frames;
  const std::vector<FrameStereo> results = ForAll<FrameStereo>(
      static_cast<int>(frames.size()), pool,
      [&](int i) { return CompareSides(scene, frames[static_cast<std::size_t>(i)]); });

  Worst across, down, median, tail, noise;
  std::vector<ImageShift> shifts;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const FrameStereo& result = results[i];
    const std::string place = StrCat("frame ", frames[i]);
    shifts.push_back(result.shift);
    noise.Add(result.noise, place);
    // As fractions of the allowed residuals, which depend on the noise.
    median.Add(result.median /
                   (limits::kMedianResidual_sigmas * result.noise + limits::kInterpolation_grey),
               StrCat(place, ": ", Short(result.median), " grey levels"));
    tail.Add(result.tail /
                 (limits::kTailResidual_sigmas * result.noise + limits::kTailInterpolation_grey),
             StrCat(place, ": ", Short(result.tail), " grey levels"));
    if (result.shift.pixels < limits::kMinShiftPixels) continue;
    across.Add(std::abs(result.shift.shift_px.x()), place);
    down.Add(std::abs(result.shift.shift_px.y()), place);
  }
  const ImageShift pooled = PoolShifts(shifts);
  SceneCheck noise_check = noise.AtMost("stereo_noise", "grey levels", 0.0);
  noise_check.bound = Bound::kNone;
  return {{"stereo_pixels", static_cast<double>(pooled.pixels), "px", Bound::kAtLeast,
           limits::kMinShiftPixels, ""},
          noise_check,
          median.AtMost("stereo_residual_median", "of allowed", 1.0),
          tail.AtMost("stereo_residual_p90", "of allowed", 1.0),
          Pooled("disparity_offset", pooled.shift_px.x()),
          Pooled("row_offset", pooled.shift_px.y()),
          across.AtMost("disparity_offset_worst", "px", limits::kShift_px),
          down.AtMost("row_offset_worst", "px", limits::kShift_px)};
}

}  // namespace cvo
