// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/frame.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::test {

// A solid box that moves through the world, with points of distinct descriptors on its faces.
struct MovingBody {
  std::string category;
  Eigen::Vector3d half_size_m;
  int points = 120;
  std::function<RigidTransform(double time_s)> world_from_body;
};

// What the camera observes in one frame, with the ground truth.
struct WorldView {
  StereoFrame frame;           // bodies' features first, then static ones
  std::vector<int> of_body;    // per feature: 0 if static, k for body k - 1
  std::vector<int> box_body;   // per detection, numbered likewise
  std::vector<int> of_static;  // per feature: index of the static point, or -1
};

// Static points and solid bodies, observed at 10 frames per second by a camera that moves forward.
// Bodies occlude everything behind them, including their own far sides. Features are simulated
// without images.
class MovingWorld {
 public:
  static constexpr std::int64_t kInterval_ns = 100'000'000;

  MovingWorld(std::uint64_t seed, std::vector<MovingBody> bodies)
      : seed_(seed), bodies_(std::move(bodies)) {
    Rng rng(seed_, "moving world");
    for (int i = 0; i < 1500; ++i) {
      points_.push_back(
          {Eigen::Vector3d(rng.Uniform(-7.0, 7.0), rng.Uniform(-3.0, 3.0), rng.Uniform(3.0, 30.0)),
           test::RandomDescriptor(rng)});
    }
    for (const MovingBody& body : bodies_) {
      on_body_.emplace_back();
      for (int i = 0; i < body.points; ++i) {
        on_body_.back().push_back({OnSurface(body.half_size_m, rng), test::RandomDescriptor(rng)});
      }
    }
  }

  const StereoCamera& camera() const { return camera_; }
  static std::int64_t TimeOf(int frame) { return frame * kInterval_ns; }

  // Returns world_from_camera: 0.5 m/s forward on a gentle curve, the identity in frame 0.
  static RigidTransform CameraAt(int frame) {
    const double turn = 0.003 * frame;
    return {ExpSo3({0.0, turn, 0.0}), Eigen::Vector3d(0.2 * turn, 0.0, 0.05 * frame)};
  }
  RigidTransform BodyAt(int body, int frame) const {
    return bodies_[body].world_from_body(0.1 * frame);
  }

  // Observes static points and all bodies, with boxes. The standard deviation of corners is
  // noise_px, that of disparities half of it. The result does not depend on earlier calls.
  WorldView Observe(int frame, double noise_px) const {
    Rng rng(seed_ + 1000 * static_cast<std::uint64_t>(frame), "noise");
    WorldView view;
    view.frame.timestamp_ns = TimeOf(frame);
    for (int b = 0; b < static_cast<int>(bodies_.size()); ++b) {
      ImageBox box{1e9, 1e9, -1e9, -1e9};
      int seen = 0;
      for (const Point& point : on_body_[b]) {
        const auto z = Project(frame, BodyAt(b, frame) * point.p);
        if (!z) continue;
        Add(*z, point.descriptor, b + 1, -1, noise_px, rng, view);
        ++seen;
        box = {std::min(box.left_px, (*z)[0]), std::min(box.top_px, (*z)[1]),
               std::max(box.right_px, (*z)[0]), std::max(box.bottom_px, (*z)[1])};
      }
      if (seen < 5) continue;
      view.frame.detections.push_back({box.Shrunk(-0.05), bodies_[b].category, 0.9});
      view.box_body.push_back(b + 1);
    }
    int still = 0;
    for (std::size_t i = 0; i < points_.size() && still < 300; ++i) {
      const auto z = Project(frame, points_[i].p);
      if (!z) continue;
      Add(*z, points_[i].descriptor, 0, static_cast<int>(i), noise_px, rng, view);
      ++still;
    }
    return view;
  }

 private:
  struct Point {
    Eigen::Vector3d p;
    Descriptor descriptor;
  };

  static Eigen::Vector3d OnSurface(const Eigen::Vector3d& half_size, Rng& rng) {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k) p[k] = half_size[k] * rng.Uniform(-1.0, 1.0);
    const int axis = static_cast<int>(rng.UniformInt(3));
    p[axis] = rng.Uniform() < 0.5 ? -half_size[axis] : half_size[axis];
    return p;
  }

  // Returns whether the ray from `from` hits the body before it reaches `to`.
  static bool Occludes(const MovingBody& body, const RigidTransform& body_from_world,
                       const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d origin = body_from_world * from;
    const Eigen::Vector3d ray = body_from_world * to - origin;
    double enter = 0.0;
    double leave = 1.0 - 1e-6;
    for (int k = 0; k < 3; ++k) {
      const double a = (-body.half_size_m[k] - origin[k]) / ray[k];
      const double b = (body.half_size_m[k] - origin[k]) / ray[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter < leave;
  }

  // Returns the stereo projection of the point; empty if the camera does not see it.
  std::optional<Eigen::Vector3d> Project(int frame, const Eigen::Vector3d& p_in_world) const {
    const RigidTransform world_from_camera = CameraAt(frame);
    const auto z = camera_.Project(world_from_camera.Inverse() * p_in_world);
    if (!z || !camera_.InImage((*z)[0], (*z)[1])) return std::nullopt;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const RigidTransform body_from_world = BodyAt(static_cast<int>(b), frame).Inverse();
      if (Occludes(bodies_[b], body_from_world, world_from_camera.translation(), p_in_world)) {
        return std::nullopt;
      }
    }
    return z;
  }

  static void Add(const Eigen::Vector3d& z_px, const Descriptor& descriptor, int body, int still,
                  double noise_px, Rng& rng, WorldView& view) {
    const double du = noise_px * rng.Normal();
    const double dv = noise_px * rng.Normal();
    StereoFeature feature;
    feature.z_px = z_px + Eigen::Vector3d(du, dv, du + 0.5 * noise_px * rng.Normal());
    feature.disagreement_px = DisagreementOf(0.5 * noise_px);
    feature.descriptor = descriptor;
    view.frame.features.push_back(feature);
    view.of_body.push_back(body);
    view.of_static.push_back(still);
  }

  std::uint64_t seed_;
  StereoCamera camera_ = kFeatureCamera;
  std::vector<MovingBody> bodies_;
  std::vector<Point> points_;
  std::vector<std::vector<Point>> on_body_;
};

// Remove a body's features or its boxes from a view.
inline void RemoveFeatures(int body, WorldView& view) {
  WorldView kept;
  for (std::size_t i = 0; i < view.of_body.size(); ++i) {
    if (view.of_body[i] == body) continue;
    kept.frame.features.push_back(view.frame.features[i]);
    kept.of_body.push_back(view.of_body[i]);
    kept.of_static.push_back(view.of_static[i]);
  }
  view.frame.features = std::move(kept.frame.features);
  view.of_body = std::move(kept.of_body);
  view.of_static = std::move(kept.of_static);
}
inline void RemoveBoxes(int body, WorldView& view) {
  for (std::size_t m = view.box_body.size(); m-- > 0;) {
    if (view.box_body[m] != body) continue;
    view.box_body.erase(view.box_body.begin() + static_cast<std::ptrdiff_t>(m));
    view.frame.detections.erase(view.frame.detections.begin() + static_cast<std::ptrdiff_t>(m));
  }
}

// Body 1 crosses from the left while turning. Body 2, on the right, moves away, stands still from
// 1.2 s to 2.4 s and then moves on.
inline std::vector<MovingBody> TwoBodies() {
  MovingBody turning{"cart", {0.7, 0.5, 0.5}, 120, {}};
  turning.world_from_body = [](double t) {
    return RigidTransform(ExpSo3({0.0, 0.3 + 0.4 * t, 0.0}),
                          Eigen::Vector3d(-2.0 + 0.5 * t, 0.4, 7.0 + 0.3 * t));
  };
  MovingBody stopping{"chair", {0.4, 0.6, 0.4}, 120, {}};
  stopping.world_from_body = [](double t) {
    const double driven = std::min(t, 1.2) + std::max(0.0, t - 2.4);
    return RigidTransform(ExpSo3({0.0, -0.5, 0.0}), Eigen::Vector3d(2.2, 0.2, 6.0 + 0.6 * driven));
  };
  return {turning, stopping};
}

}  // namespace cvo::test
