// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "synth/models/model.h"
#include "synth/motion/motion.h"

namespace cvo::synth {

// Where things are over a whole scene, in steps of 1/30 s.
struct Track {
  CollisionShape shape;  // around the body's origin
  std::vector<RigidTransform> world_from_body;
  double in_view = 0.0;       // least part of the time in view
  std::vector<bool> visible;  // in view, and nothing between its middle and the camera

  // Between the first and the last step.
  double Moved_m() const;
};

struct PlacementLimits {
  double clearance_m = 0.1;            // between bodies, at the steps
  double camera_clearance_m = 0.6;     // between bodies and the camera
  double view_m = 1e6;                 // bodies further away do not count as in view
  std::vector<Eigen::Vector4d> walls;  // inward planes that bodies stay behind
};

// Bodies placed one after the other, none of which comes near another, a wall or the camera.
class Placement {
 public:
  Placement(const StereoCamera& rig, const Motion& camera, double duration_s,
            PlacementLimits limits);

  // Adds a body whose middle is in the left image, not too far away, for at least the part
  // `in_view` of the time. It comes near nothing and hides no other body most of the time, nor is
  // it hidden. Otherwise changes nothing and returns false.
  bool TryAdd(const CollisionShape& shape, const Motion& motion, double in_view);

  const std::vector<Track>& bodies() const { return bodies_; }
  const Track& camera() const { return camera_; }
  double duration_s() const { return duration_s_; }

 private:
  Track MakeTrack(const CollisionShape& shape, const Motion& motion) const;
  bool StaysInside(const Track& track) const;
  bool HasClearance(const Track& a, const Track& b, double clearance_m) const;
  std::vector<bool> InView(const Track& track) const;
  // The track's `visible`, less where the other body hides its middle.
  std::vector<bool> VisibleBehind(const Track& track, const Track& other) const;
  bool TryVisibility(Track& track);

  StereoCamera rig_;
  double duration_s_;
  PlacementLimits limits_;
  Track camera_;
  std::vector<Track> bodies_;
};

}  // namespace cvo::synth
