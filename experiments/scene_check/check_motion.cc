// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "experiments/scene_check/checks.h"
#include "experiments/scene_check/limits.h"
#include "experiments/scene_check/reprojection.h"

namespace cvo {
namespace {

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

double Median(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
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
    if (static_cast<int>(predictions.size()) < limits::kMinShiftPixels) continue;
    ImageShift shift = EstimateShift(image, next_image, predictions);
    const double residual = Median(std::exchange(shift.residuals, {}));
    motions.push_back(
        {body, frame, std::move(shift), Median(std::move(depth_errors)), residual, noise});
  }
  return motions;
}

std::string NameOf(const SceneFolder& scene, int body) {
  return body == 0 ? "background" : scene.bodies[0][static_cast<std::size_t>(body) - 1].name;
}

}  // namespace

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
      const double allowed = limits::kMedianResidual_sigmas * motion.noise +
                             (background ? limits::kInterpolation_grey : limits::kShading_grey);
      (background ? background_residual : body_residual)
          .Add(motion.median_residual / allowed,
               StrCat(place, ": ", Short(motion.median_residual), " grey levels"));
    }
  }
  Worst bodies;
  ImageShift background;
  int measured = 0;
  for (const auto& [body, of_body] : shifts) {
    const ImageShift pooled = PoolShifts(of_body);
    if (body == 0) background = pooled;
    if (body == 0 || pooled.MaxSigma_px() > limits::kMaxShiftSigma_px) continue;
    ++measured;
    bodies.Add(pooled.shift_px.norm(), NameOf(scene, body));
  }
  return {
      {"motion_pixels_background", static_cast<double>(background.pixels), "px", Bound::kNone, 0.0,
       ""},
      {"motion_bodies_measured", static_cast<double>(measured), "bodies", Bound::kNone, 0.0, ""},
      depths.AtMost("motion_depth", "px", limits::kDepthMotion_px),
      {"motion_shift_background", background.shift_px.norm(), "px", Bound::kAtMost,
       limits::kShift_px, "all frames together"},
      background_shift.AtMost("motion_shift_background_worst", "px", limits::kFrameShift_px),
      background_residual.AtMost("motion_residual_background", "of allowed", 1.0),
      bodies.AtMost("motion_shift_bodies", "px", limits::kShift_px),
      body_residual.AtMost("motion_residual_bodies", "of allowed", 1.0)};
}

namespace {

// Returns the largest difference between flow and reprojection over the valid pixels of the frame;
// negative if there are none.
double CompareFlow(const SceneFolder& scene, int frame) {
  const StereoCamera& camera = scene.sequence.camera;
  const TruthFlow flow = ReadFlow(scene.FileOf("flow_0", frame, ".png"), scene.size());
  const Surface surface = {scene.Depth(frame), scene.Instances(frame)};
  std::vector<RigidTransform> next_from_this;
  for (int body = 0; body <= static_cast<int>(scene.bodies[0].size()); ++body) {
    next_from_this.push_back(RelativeMotion(scene, frame, body));
  }
  double worst_px = -1.0;
  for (int v = 0; v < scene.size().height; ++v) {
    for (int u = 0; u < scene.size().width; ++u) {
      if (flow.valid.at<unsigned char>(v, u) == 0) continue;
      const std::size_t body = surface.instances.at<std::uint16_t>(v, u);
      if (!(surface.depth.at<float>(v, u) > 0.0F) || body >= next_from_this.size()) return 1e9;
      const auto z_px = camera.Project(next_from_this[body] * PointAt(camera, surface.depth, u, v));
      if (!z_px) return 1e9;
      const auto& found = flow.flow_px.at<cv::Vec2f>(v, u);
      const double du = static_cast<double>(found[0]) - ((*z_px)[0] - u);
      const double dv = static_cast<double>(found[1]) - ((*z_px)[1] - v);
      worst_px = std::max({worst_px, std::abs(du), std::abs(dv)});
    }
  }
  return worst_px;
}

}  // namespace

std::vector<SceneCheck> CheckFlow(const SceneFolder& scene, TaskPool& pool) {
  if (!std::filesystem::is_directory(scene.path / "flow_0")) return {};
  std::vector<int> frames = scene.image_frames;
  std::erase(frames, scene.frame_count() - 1);
  const std::vector<double> results = ForAll<double>(
      static_cast<int>(frames.size()), pool,
      [&](int i) { return CompareFlow(scene, frames[static_cast<std::size_t>(i)]); });
  Worst worst;
  int without = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i] < 0.0) ++without;
    worst.Add(results[i], StrCat("frame ", frames[i]));
  }
  return {worst.AtMost("flow_error", "px", limits::kFlow_px),
          {"frames_without_flow", static_cast<double>(without), "frames", Bound::kAtMost, 0.0, ""}};
}

}  // namespace cvo
