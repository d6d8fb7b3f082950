// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/body_score.h"

#include <cmath>

namespace cvo {
namespace {

struct Residuals {
  int seen = 0;
  double squared = 0.0;  // whitened, mean over the landmarks seen
};

Residuals ResidualsOf(const FeatureNoise& noise, const FrameView& view, FrameId newest,
                      const Cluster& cluster) {
  Residuals residuals;
  const ClusterState* state = FindState(cluster, newest);
  if (state == nullptr) return residuals;
  const RigidTransform camera_from_object =
      view.world_from_camera.Inverse() * state->world_from_object;
  for (const Landmark& landmark : cluster.landmarks) {
    const Observation* seen = FindObservation(landmark, newest);
    const auto z_px = view.camera.Project(camera_from_object * landmark.p_in_object);
    if (seen == nullptr || !z_px) continue;
    ++residuals.seen;
    residuals.squared += (noise.SqrtInformation(*seen) * (seen->z_px - *z_px)).squaredNorm();
  }
  if (residuals.seen > 0) residuals.squared /= residuals.seen;
  return residuals;
}

}  // namespace

double ScoreOf(const FeatureNoise& noise, const ClusterOptions& options, const FrameView* view,
               FrameId newest, const Cluster& cluster) {
  const Residuals residuals =
      view == nullptr ? Residuals() : ResidualsOf(noise, *view, newest, cluster);
  const double undetected = static_cast<double>(newest.value - cluster.last_detected.value);
  const double by_detector = 0.5 * (1.0 + cluster.score / (1.0 + std::abs(cluster.score)));
  const double by_age = cluster.detections / (cluster.detections + 1.0);
  const double by_landmarks =
      (residuals.seen + 1.0) / (residuals.seen + 1.0 + options.min_landmarks);
  const double by_residuals = 1.0 / (1.0 + residuals.squared / noise.options.gate);
  return by_detector * std::pow(options.score_decay, undetected) * by_age * by_landmarks *
         by_residuals;
}

}  // namespace cvo
