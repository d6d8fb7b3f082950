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

// Poses of a body or of the camera over a whole scene, in equal steps of at most 1/30 s.
struct Track {
  CollisionShape shape;  // around the body's origin
  std::vector<RigidTransform> world_from_body;
  double in_view = 0.0;       // minimum fraction of the time in view
  std::vector<bool> visible;  // in view, and no body between its centre and the camera

  // Distance between the positions at the first and the last step.
  double Moved_m() const;
};

struct PlacementLimits {
  double clearance_m = 0.1;            // between bodies, checked at the steps
  double camera_clearance_m = 0.6;     // between bodies and the camera
  double view_m = 1e6;                 // bodies further away do not count as in view
  std::vector<Eigen::Vector4d> walls;  // planes with inward normals that bodies must not cross
};

// Places bodies one after the other so that none comes near another body, a wall or the camera.
class Placement {
 public:
  Placement(const StereoCamera& rig, const Motion& camera, double duration_s,
            PlacementLimits limits);

  // Adds a body if its centre is in the left image, within view_m, for at least the fraction
  // `in_view` of the time, if it keeps all clearances, and if neither it nor any other body is then
  // hidden most of the time. Otherwise changes nothing and returns false.
  bool TryAdd(const CollisionShape& shape, const Motion& motion, double in_view);

  const std::vector<Track>& bodies() const { return bodies_; }
  const Track& camera() const { return camera_; }
  double duration_s() const { return duration_s_; }

 private:
  Track MakeTrack(const CollisionShape& shape, const Motion& motion) const;
  bool StaysInside(const Track& track) const;
  bool HasClearance(const Track& a, const Track& b, double clearance_m) const;
  std::vector<bool> InView(const Track& track) const;
  // Returns `track.visible` without the steps in which `other` hides the centre of the body.
  std::vector<bool> VisibleBehind(const Track& track, const Track& other) const;
  bool TryVisibility(Track& track);

  StereoCamera rig_;
  double duration_s_;
  PlacementLimits limits_;
  Track camera_;
  std::vector<Track> bodies_;
};

}  // namespace cvo::synth
