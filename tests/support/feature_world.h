// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/rng.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/frame.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::test {

// A static world of points with distinct descriptors. Produces stereo frames without images, to
// test everything downstream of the front end.
class FeatureWorld {
 public:
  // Creates points around the path of a camera that drives along z.
  explicit FeatureWorld(std::uint64_t seed, int points = 3000) : rng_(seed, "feature world") {
    camera_ = {.fx = 450.0,
               .fy = 450.0,
               .cx = 319.5,
               .cy = 239.5,
               .baseline_m = 0.3,
               .width_px = 640,
               .height_px = 480};
    for (int i = 0; i < points; ++i) {
      points_.emplace_back(rng_.Uniform(-8.0, 8.0), rng_.Uniform(-3.0, 3.0),
                           rng_.Uniform(3.0, 60.0));
      descriptors_.push_back(test::RandomDescriptor(rng_));
    }
  }

  const StereoCamera& camera() const { return camera_; }
  const std::vector<Eigen::Vector3d>& points() const { return points_; }

  // Returns world_from_camera: speed_m forward per frame, on a gentle curve.
  static RigidTransform CameraAt(int frame, double speed_m = 0.3) {
    const double turn = 0.004 * frame;
    return {ExpSo3({0.0, turn, 0.0}),
            Eigen::Vector3d(0.5 * turn * speed_m * frame, 0.0, speed_m * frame)};
  }

  // Returns at most 500 features. The standard deviation of corners is noise_px, that of
  // disparities half of it.
  StereoFrame Observe(const RigidTransform& world_from_camera, std::int64_t timestamp_ns,
                      double noise_px) {
    StereoFrame frame;
    frame.timestamp_ns = timestamp_ns;
    const RigidTransform camera_from_world = world_from_camera.Inverse();
    for (std::size_t i = 0; i < points_.size() && frame.features.size() < 500; ++i) {
      const Eigen::Vector3d p_in_camera = camera_from_world * points_[i];
      const auto z = camera_.Project(p_in_camera);
      if (!z || p_in_camera.z() > 30.0 || !camera_.InImage((*z)[0], (*z)[1])) continue;
      const double du = noise_px * rng_.Normal();
      const Eigen::Vector3d noise(du, noise_px * rng_.Normal(),
                                  du + 0.5 * noise_px * rng_.Normal());
      StereoFeature feature;
      feature.z_px = *z + noise;
      feature.disagreement_px = DisagreementOf(0.5 * noise_px);
      feature.descriptor = descriptors_[i];
      frame.features.push_back(feature);
    }
    return frame;
  }

 private:
  Rng rng_;
  StereoCamera camera_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Descriptor> descriptors_;
};

}  // namespace cvo::test
