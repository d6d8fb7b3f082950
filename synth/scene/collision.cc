// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "core/files/text/number.h"
#include "synth/scene/world.h"

namespace cvo::synth {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Box {
  Vector3d centre;
  Matrix3d axes;  // columns
  Vector3d half_m;
};

double BallToBall(const Vector3d& a, double radius_a, const Vector3d& b, double radius_b) {
  return (b - a).norm() - radius_a - radius_b;
}

double BallToBox(const Vector3d& ball, double radius, const Box& box) {
  const Vector3d local = box.axes.transpose() * (ball - box.centre);
  const Vector3d outside = local.cwiseAbs() - box.half_m;
  if (outside.maxCoeff() <= 0.0) return outside.maxCoeff() - radius;
  return outside.cwiseMax(0.0).norm() - radius;
}

// Separating axis test: returns the greatest gap along the 15 axes that can separate two boxes.
double BoxToBox(const Box& a, const Box& b) {
  const Vector3d apart = b.centre - a.centre;
  double widest = -1e300;
  const auto try_axis = [&](const Vector3d& axis) {
    const double gap = std::abs(axis.dot(apart)) -
                       (a.axes.transpose() * axis).cwiseAbs().dot(a.half_m) -
                       (b.axes.transpose() * axis).cwiseAbs().dot(b.half_m);
    widest = std::max(widest, gap);
  };
  for (int i = 0; i < 3; ++i) {
    try_axis(a.axes.col(i));
    try_axis(b.axes.col(i));
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3d edge = a.axes.col(i).cross(b.axes.col(j));
      const double length = edge.norm();
      if (length > 1e-6) try_axis(edge / length);  // parallel edges add no direction
    }
  }
  return widest;
}

Box MakeBox(const CollisionShape& shape, const RigidTransform& world_from_shape) {
  return {world_from_shape.translation(), world_from_shape.RotationMatrix(), shape.half_size_m};
}

double Radius_m(const CollisionShape& shape) {
  return shape.radius_m > 0.0 ? shape.radius_m : shape.half_size_m.norm();
}

constexpr double kTolerance_m = 1e-3;
constexpr double kLongestStep_m = 0.02;  // of solids that nearly touch
constexpr double kWallStep_m = 0.05;     // longer: a wall has no other side to come out of
constexpr double kNever_s = std::numeric_limits<double>::infinity();

// A solid with bounds that make most checks cheap.
struct Moving {
  const Solid* solid = nullptr;
  double radius_m = 0.0;      // around the model's origin
  double fastest_mps = 0.0;   // bound for all of its points
  double least_half_m = 0.0;  // smallest half side or radius of its shapes
  Eigen::AlignedBox3d swept;  // bounds of the solid at all times

  RigidTransform At(double time_s) const {
    return solid->motion ? solid->motion->At(time_s).world_from_body : solid->world_from_model;
  }
};

double LeastHalf_m(const std::vector<CollisionShape>& shapes) {
  double least = std::numeric_limits<double>::infinity();
  for (const CollisionShape& shape : shapes) {
    least = std::min(least, shape.radius_m > 0.0 ? shape.radius_m : shape.half_size_m.minCoeff());
  }
  return least;
}

Moving MakeMoving(const Solid& solid, double duration_s) {
  constexpr double kSample_s = 1.0 / 60.0;
  Moving moving{&solid, BoundingRadius_m(solid.shapes), 0.0, LeastHalf_m(solid.shapes), {}};
  if (!solid.motion) {
    moving.swept.extend(Vector3d(solid.world_from_model.translation()));
  } else {
    const int samples = 1 + static_cast<int>(std::ceil(duration_s / kSample_s));
    for (int i = 0; i <= samples; ++i) {
      const MotionState state = solid.motion->At(duration_s * i / samples);
      const double turning = state.angular_velocity_in_world.norm() * moving.radius_m;
      moving.fastest_mps = std::max(moving.fastest_mps, state.velocity_in_world.norm() + turning);
      moving.swept.extend(Vector3d(state.world_from_body.translation()));
    }
    // The speed may be slightly higher between samples.
    if (moving.fastest_mps > 0.0) moving.fastest_mps = 1.1 * moving.fastest_mps + 0.01;
  }
  const double margin = moving.radius_m + moving.fastest_mps * kSample_s + kTolerance_m;
  moving.swept.min().array() -= margin;
  moving.swept.max().array() += margin;
  return moving;
}

// Evaluates the shapes only if the bounding spheres are close; otherwise returns the distance of
// the spheres.
double SeparationOf(const Moving& a, const Moving& b, double time_s) {
  constexpr double kFar_m = 0.5;
  const RigidTransform at_a = a.At(time_s);
  const RigidTransform at_b = b.At(time_s);
  const double around = (at_a.translation() - at_b.translation()).norm() - a.radius_m - b.radius_m;
  if (around > kFar_m) return around;
  double least = std::numeric_limits<double>::infinity();
  for (const CollisionShape& shape_a : a.solid->shapes) {
    for (const CollisionShape& shape_b : b.solid->shapes) {
      least = std::min(least, Separation(shape_a, at_a, shape_b, at_b));
    }
  }
  return least;
}

double SeparationOf(const Moving& a, const Eigen::Vector4d& plane, double time_s) {
  const RigidTransform at = a.At(time_s);
  double least = std::numeric_limits<double>::infinity();
  for (const CollisionShape& shape : a.solid->shapes) {
    least = std::min(least, PlaneSeparation(shape, at, plane));
  }
  return least;
}

struct Collision {
  double time_s = kNever_s;
  double depth_m = 0.0;
};

// Steps through time by the present separation divided by the greatest closing speed. This can only
// miss an overlap during which the solids move by less than the shortest step.
template <typename SeparationAt>
Collision FindCollision(const SeparationAt& separation_at, double closing_mps,
                        double shortest_step_m, double duration_s) {
  for (double time_s = 0.0; time_s <= duration_s;) {
    const double separation = separation_at(time_s);
    if (separation < -kTolerance_m) return {time_s, -separation};
    if (closing_mps <= 0.0) break;
    time_s += std::max(separation, shortest_step_m) / closing_mps;
  }
  return {};
}

// A pair of solids, or a solid and a wall.
struct SolidPair {
  std::size_t first = 0;
  std::size_t second = 0;
  bool with_wall = false;
};

std::vector<SolidPair> FindPairs(const std::vector<Moving>& solids,
                                 const std::vector<Eigen::Vector4d>& walls) {
  std::vector<SolidPair> pairs;
  std::vector<std::size_t> order(solids.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return solids[i].swept.min().x() < solids[j].swept.min().x();
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Moving& a = solids[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Moving& b = solids[order[j]];
      if (b.swept.min().x() > a.swept.max().x()) break;
      const bool both_stay = !a.solid->motion && !b.solid->motion;
      if (both_stay || !a.swept.intersects(b.swept)) continue;
      pairs.push_back({std::min(order[i], order[j]), std::max(order[i], order[j]), false});
    }
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (!solids[i].solid->motion) continue;
    for (std::size_t wall = 0; wall < walls.size(); ++wall) pairs.push_back({i, wall, true});
  }
  return pairs;
}

double ShortestStep_m(double least_half_m) { return std::min(kLongestStep_m, 0.1 * least_half_m); }

Collision FindCollision(const SolidPair& pair, const std::vector<Moving>& solids,
                        const std::vector<Eigen::Vector4d>& walls, double duration_s) {
  const Moving& a = solids[pair.first];
  if (pair.with_wall) {
    const auto separation = [&](double t) { return SeparationOf(a, walls[pair.second], t); };
    return FindCollision(separation, a.fastest_mps, kWallStep_m, duration_s);
  }
  const Moving& b = solids[pair.second];
  const auto separation = [&](double t) { return SeparationOf(a, b, t); };
  return FindCollision(separation, a.fastest_mps + b.fastest_mps,
                       ShortestStep_m(std::min(a.least_half_m, b.least_half_m)), duration_s);
}

std::string WallName(const Eigen::Vector4d& wall) {
  if (wall[2] > 0.7) return "the floor";
  return wall[2] < -0.7 ? "the ceiling" : "a wall";
}

// Whether a sphere in the left camera's frame may intersect its field of view.
bool MayShow(const StereoCamera& rig, const Vector3d& centre, double radius_m) {
  if (centre.z() + radius_m <= StereoCamera::kMinDepth_m) return false;
  const double left = (-0.5 - rig.cx) / rig.fx, right = (rig.width_px - 0.5 - rig.cx) / rig.fx;
  const double top = (-0.5 - rig.cy) / rig.fy, bottom = (rig.height_px - 0.5 - rig.cy) / rig.fy;
  for (const Vector3d& inward : {Vector3d(1, 0, -left), Vector3d(-1, 0, right),
                                 Vector3d(0, 1, -top), Vector3d(0, -1, bottom)}) {
    if (inward.normalized().dot(centre) < -radius_m) return false;
  }
  return true;
}

}  // namespace

double Separation(const CollisionShape& a, const RigidTransform& world_from_a,
                  const CollisionShape& b, const RigidTransform& world_from_b) {
  const RigidTransform at_a = world_from_a * a.model_from_shape;
  const RigidTransform at_b = world_from_b * b.model_from_shape;
  const double around =
      BallToBall(at_a.translation(), Radius_m(a), at_b.translation(), Radius_m(b));
  const bool a_is_ball = a.radius_m > 0.0;
  const bool b_is_ball = b.radius_m > 0.0;
  if (around > 0.5 || (a_is_ball && b_is_ball)) return around;
  if (a_is_ball) return BallToBox(at_a.translation(), a.radius_m, MakeBox(b, at_b));
  if (b_is_ball) return BallToBox(at_b.translation(), b.radius_m, MakeBox(a, at_a));
  return BoxToBox(MakeBox(a, at_a), MakeBox(b, at_b));
}

double PlaneSeparation(const CollisionShape& shape, const RigidTransform& world_from_model,
                       const Eigen::Vector4d& plane) {
  const RigidTransform at = world_from_model * shape.model_from_shape;
  const Vector3d normal = plane.head<3>();
  const double centre = normal.dot(at.translation()) + plane[3];
  if (shape.radius_m > 0.0) return centre - shape.radius_m;
  return centre - (at.RotationMatrix().transpose() * normal).cwiseAbs().dot(shape.half_size_m);
}

double BoundingRadius_m(const std::vector<CollisionShape>& shapes) {
  double radius = 0.0;
  for (const CollisionShape& shape : shapes) {
    radius = std::max(radius, shape.model_from_shape.translation().norm() + Radius_m(shape));
  }
  return radius;
}

void CheckCollisions(const std::vector<Solid>& solids, const std::vector<Eigen::Vector4d>& walls,
                     double duration_s, int threads, const std::string& where) {
  TaskPool pool(threads);
  std::vector<Moving> moving(solids.size());
  pool.ParallelFor(static_cast<int>(solids.size()),
                   [&](int i) { moving[i] = MakeMoving(solids[i], duration_s); });
  const std::vector<SolidPair> pairs = FindPairs(moving, walls);
  std::vector<Collision> collisions(pairs.size());
  pool.ParallelFor(static_cast<int>(pairs.size()), [&](int i) {
    collisions[i] = FindCollision(pairs[i], moving, walls, duration_s);
  });
  const auto first =
      std::min_element(collisions.begin(), collisions.end(),
                       [](const Collision& a, const Collision& b) { return a.time_s < b.time_s; });
  if (first == collisions.end() || first->time_s == kNever_s) return;
  const SolidPair& pair = pairs[first - collisions.begin()];
  const std::string second =
      pair.with_wall ? WallName(walls[pair.second]) : solids[pair.second].name;
  ThrowError(where,
             StrCat(solids[pair.first].name, " and ", second, " overlap by ",
                    FormatFixed(first->depth_m, 3), " m at ", FormatFixed(first->time_s, 2), " s"),
             "no collisions");
}

void CheckInView(const World& world, const std::string& where) {
  std::vector<bool> seen(world.bodies.size(), false);
  for (int frame = 0; frame < world.frames; ++frame) {
    const double time_s = world.Time_s(frame);
    const RigidTransform left_from_world = world.camera->At(time_s).world_from_body.Inverse();
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i]) continue;
      const Body& body = world.bodies[i];
      const Vector3d centre = body.motion->At(time_s).world_from_body.translation();
      seen[i] = MayShow(world.rig, left_from_world * centre, 0.5 * body.size_m.norm());
    }
  }
  const auto unseen = std::find(seen.begin(), seen.end(), false);
  if (unseen == seen.end()) return;
  ThrowError(where, world.bodies[unseen - seen.begin()].name + " never in front of the camera",
             "bodies that may be visible in at least one frame");
}

}  // namespace cvo::synth
