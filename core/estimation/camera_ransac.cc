// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/camera_ransac.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cvo {
namespace {

std::array<std::size_t, 3> DrawSample(std::size_t n, Rng& rng) {
  std::array<std::size_t, 3> sample{};
  sample[0] = rng.UniformInt(n);
  do sample[1] = rng.UniformInt(n);
  while (sample[1] == sample[0]);
  do sample[2] = rng.UniformInt(n);
  while (sample[2] == sample[0] || sample[2] == sample[1]);
  return sample;
}

// Empty if one of the measurements cannot be triangulated.
std::optional<RigidTransform> AlignSample(const StereoCamera& camera,
                                          std::span<const PointMeasurement> measurements,
                                          const std::array<std::size_t, 3>& sample) {
  Eigen::Matrix3Xd in_camera(3, 3);
  Eigen::Matrix3Xd in_world(3, 3);
  for (int k = 0; k < 3; ++k) {
    const PointMeasurement& measurement = measurements[sample[k]];
    const auto point = camera.BackProject(measurement.z_px);
    if (!point) return std::nullopt;
    in_camera.col(k) = *point;
    in_world.col(k) = measurement.p_in_world;
  }
  return AlignPoints(in_camera, in_world);
}

}  // namespace

int CountInliers(const StereoCamera&, std::span<const PointMeasurement>,
                 std::span<const char> is_inlier) {
  return static_cast<int>(std::ranges::count(is_inlier, 1));
}

std::optional<CameraSolution> SolveCameraRansac(const StereoCamera& camera,
                                                std::span<const PointMeasurement> measurements,
                                                const NoiseOptions& noise, Support& support,
                                                int iterations, int min_inliers, Rng& rng) {
  if (measurements.size() < 3) return std::nullopt;
  CameraSolution best;
  int best_support = 0;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const auto world_from_camera =
        AlignSample(camera, measurements, DrawSample(measurements.size(), rng));
    if (!world_from_camera) continue;
    CameraSolution agreeing = ClassifyMeasurements(camera, measurements, *world_from_camera,
                                                   noise.hypothesis_gate * noise.gate);
    const int supported = support(camera, measurements, agreeing.is_inlier);
    if (agreeing.inliers >= 3 && supported > best_support) {
      best_support = supported;
      best = std::move(agreeing);
    }
  }
  if (best_support == 0) return std::nullopt;

  // Refines only on the inliers of the hypothesis, because SolveCamera starts by trusting all its
  // measurements.
  std::vector<PointMeasurement> close;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (best.is_inlier[i]) close.push_back(measurements[i]);
  }
  const RigidTransform refined =
      SolveCamera(camera, close, best.world_from_camera, noise).world_from_camera;
  CameraSolution solution = ClassifyMeasurements(camera, measurements, refined, noise.gate);
  if (solution.inliers < min_inliers) return std::nullopt;
  return solution;
}

}  // namespace cvo
