// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/family/placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "synth/scene/separation.h"

namespace cvo::synth {
namespace {

constexpr double kTrackStep_s = 1.0 / 30.0;
constexpr double kCameraRadius_m = 0.15;
constexpr double kRounding_m = 1e-6;  // tolerance for bodies that stand on the floor
constexpr double kLeastDepth_m = 0.4;
constexpr double kVisiblePart = 0.6;  // fraction of Track::in_view that must stay visible

bool IsInView(const StereoCamera& rig, double view_m, const Eigen::Vector3d& p_in_left) {
  if (p_in_left.z() < kLeastDepth_m || p_in_left.z() > view_m) return false;
  const double u = rig.fx * p_in_left.x() / p_in_left.z() + rig.cx;
  const double v = rig.fy * p_in_left.y() / p_in_left.z() + rig.cy;
  return u >= 0.0 && v >= 0.0 && u < rig.width_px && v < rig.height_px;
}

// Whether the line segment between two points intersects an axis-aligned box around the origin.
bool Crosses(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& half) {
  double first = 0.0;
  double last = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double step = to[axis] - from[axis];
    if (std::abs(step) < 1e-9) {
      if (std::abs(from[axis]) > half[axis]) return false;
      continue;
    }
    const double low = (-half[axis] - from[axis]) / step;
    const double high = (half[axis] - from[axis]) / step;
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  return first <= last;
}

double PartOf(const std::vector<bool>& steps) {
  return static_cast<double>(std::count(steps.begin(), steps.end(), true)) /
         static_cast<double>(steps.size());
}

}  // namespace

double Track::Moved_m() const {
  return (world_from_body.back().translation() - world_from_body.front().translation()).norm();
}

Placement::Placement(const StereoCamera& rig, const Motion& camera, double duration_s,
                     PlacementLimits limits)
    : rig_(rig), duration_s_(duration_s), limits_(std::move(limits)) {
  CollisionShape ball;
  ball.radius_m = kCameraRadius_m;
  camera_ = MakeTrack(ball, camera);
}

Track Placement::MakeTrack(const CollisionShape& shape, const Motion& motion) const {
  Track track;
  track.shape = shape;
  const int steps = static_cast<int>(std::ceil(duration_s_ / kTrackStep_s));
  for (int i = 0; i <= steps; ++i) {
    track.world_from_body.push_back(motion.At(duration_s_ * i / steps).world_from_body);
  }
  return track;
}

bool Placement::StaysInside(const Track& track) const {
  return std::all_of(limits_.walls.begin(), limits_.walls.end(), [&](const Eigen::Vector4d& wall) {
    return std::all_of(track.world_from_body.begin(), track.world_from_body.end(),
                       [&](const RigidTransform& at) {
                         return PlaneSeparation(track.shape, at, wall) >= -kRounding_m;
                       });
  });
}

bool Placement::HasClearance(const Track& a, const Track& b, double clearance_m) const {
  for (std::size_t i = 0; i < a.world_from_body.size(); ++i) {
    if (Separation(a.shape, a.world_from_body[i], b.shape, b.world_from_body[i]) < clearance_m) {
      return false;
    }
  }
  return true;
}

std::vector<bool> Placement::InView(const Track& track) const {
  std::vector<bool> seen;
  for (std::size_t i = 0; i < track.world_from_body.size(); ++i) {
    const RigidTransform left_from_world = camera_.world_from_body[i].Inverse();
    const Eigen::Vector3d p_in_left = left_from_world * track.world_from_body[i].translation();
    seen.push_back(IsInView(rig_, limits_.view_m, p_in_left));
  }
  return seen;
}

std::vector<bool> Placement::VisibleBehind(const Track& track, const Track& other) const {
  std::vector<bool> visible = track.visible;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const RigidTransform other_from_world = other.world_from_body[i].Inverse();
    if (!visible[i]) continue;
    visible[i] = !Crosses(other_from_world * camera_.world_from_body[i].translation(),
                          other_from_world * track.world_from_body[i].translation(),
                          other.shape.half_size_m);
  }
  return visible;
}

// Also updates the bodies placed before: none may be hidden most of the time.
bool Placement::TryVisibility(Track& track) {
  std::vector<std::vector<bool>> visible;
  for (const Track& other : bodies_) {
    track.visible = VisibleBehind(track, other);
    visible.push_back(VisibleBehind(other, track));
    if (PartOf(visible.back()) < kVisiblePart * other.in_view) return false;
  }
  if (PartOf(track.visible) < kVisiblePart * track.in_view) return false;
  for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].visible = std::move(visible[i]);
  return true;
}

bool Placement::TryAdd(const CollisionShape& shape, const Motion& motion, double in_view) {
  Track track = MakeTrack(shape, motion);
  track.in_view = in_view;
  track.visible = InView(track);
  if (!StaysInside(track) || PartOf(track.visible) < in_view) return false;
  if (!HasClearance(track, camera_, limits_.camera_clearance_m)) return false;
  for (const Track& other : bodies_) {
    if (!HasClearance(track, other, limits_.clearance_m)) return false;
  }
  if (!TryVisibility(track)) return false;
  bodies_.push_back(std::move(track));
  return true;
}

}  // namespace cvo::synth
