// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "synth/family/family.h"
#include "synth/motion/motion.h"
#include "synth/scene/world.h"

namespace cvo::synth {
namespace {

using Knots = std::vector<SpeedProfile::Knot>;

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

// Places one stop in each of several equal parts of the time.
Knots WithStops(const SpeedRequest& request, Rng& rng) {
  constexpr double kRamp_s = 0.5;
  constexpr double kShortestPart_s = 2.4;
  Knots knots = {{0.0, request.speed_mps}};
  const int stops = std::min(request.stops, static_cast<int>(request.duration_s / kShortestPart_s));
  for (int i = 0; i < stops; ++i) {
    const double part_s = request.duration_s / stops;
    const double pause_s = rng.Uniform(0.5, std::min(2.0, part_s - 1.4));
    const double start_s =
        part_s * i + rng.Uniform(0.2, std::max(0.25, part_s - pause_s - 2.0 * kRamp_s - 0.1));
    knots.push_back({start_s, request.speed_mps});
    knots.push_back({start_s + kRamp_s, 0.0});
    knots.push_back({start_s + kRamp_s + pause_s, 0.0});
    knots.push_back({start_s + 2.0 * kRamp_s + pause_s, request.speed_mps});
  }
  return knots;
}

// Adds a final stop if the distance would exceed `length_m`.
void StopWithin(double length_m, double duration_s, Knots& knots) {
  constexpr double kStop_s = 0.8;
  constexpr double kStopStep_s = 0.05;
  const SpeedProfile profile(knots);
  if (profile.Way_m(duration_s) <= length_m) return;
  double time_s = 0.0;
  while (profile.Way_m(time_s + kStopStep_s) +
             0.5 * kStop_s * profile.Speed_mps(time_s + kStopStep_s) <
         length_m) {
    time_s += kStopStep_s;
  }
  const double speed_mps = profile.Speed_mps(time_s);
  std::erase_if(knots, [&](const SpeedProfile::Knot& knot) { return knot.time_s >= time_s; });
  knots.push_back({time_s, speed_mps});
  knots.push_back({time_s + kStop_s, 0.0});
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

Json PointJson(const Eigen::Vector2d& point) {
  return Json::array({Millis(point.x()), Millis(point.y())});
}

Json SpeedKnots(const SpeedRequest& request, Rng& rng) {
  Knots knots = WithStops(request, rng);
  StopWithin(request.length_m, request.duration_s, knots);
  if (knots.size() == 1) return Millis(request.speed_mps);
  Json rows = Json::array();
  for (const SpeedProfile::Knot& knot : knots) {
    rows.push_back({Millis(knot.time_s), Millis(knot.speed_mps)});
  }
  return rows;
}

}  // namespace cvo::synth
