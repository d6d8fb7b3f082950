// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/clusters/cluster_map.h"
#include "core/clusters/cluster_optimization.h"
#include "tests/support/estimator_inputs.h"

// Helpers to create states, landmarks and windows of a few frames, 0.1 s apart.
namespace cvo::test {

inline constexpr std::int64_t kInterval_ns = 100'000'000;
inline const StereoCamera kCamera = CentredCamera(450, 0.3, 640, 480);

inline constexpr EnergySteps kOurEnergy{&StepsOfPrior<WhiteNoiseOnAcceleration>,
                                        &RemoveOutliers::Gate, &OwnSchur::Solve, &OwnSchur::Solve};

inline RigidTransform At(double x, double y, double z, double yaw = 0.0) {
  return {ExpSo3({0.0, yaw, 0.0}), Eigen::Vector3d(x, y, z)};
}

inline ClusterState StateAt(std::int64_t frame, const RigidTransform& world_from_object,
                            const Eigen::Vector3d& velocity_m_s = Eigen::Vector3d::Zero()) {
  return {FrameId{frame}, frame * kInterval_ns, world_from_object, velocity_m_s};
}

inline Landmark MakeLandmark(std::int64_t id, const std::vector<std::int64_t>& frames) {
  Landmark landmark;
  landmark.id = LandmarkId{id};
  for (const std::int64_t frame : frames) {
    landmark.observations.push_back({FrameId{frame}, {300.0, 200.0, 280.0}, 0});
    landmark.last_seen = FrameId{frame};
  }
  return landmark;
}

inline Window WindowOf(std::int64_t first, std::int64_t last) {
  Window window;
  window.camera = kCamera;
  for (std::int64_t f = first; f <= last; ++f) window.temporal.push_back({FrameId{f}, {}, false});
  return window;
}

}  // namespace cvo::test
