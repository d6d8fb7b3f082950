// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/body_place.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/association/box_association.h"
#include "core/bodies/body_boxes.h"
#include "core/clustering/point_extent.h"

namespace cvo {

Eigen::Vector3d Levelled(const Eigen::Vector3d& direction, const Eigen::Vector3d& down) {
  const Eigen::Vector3d level = direction - down * down.dot(direction);
  constexpr double kVertical = 1e-6;
  if (level.norm() > kVertical * direction.norm()) return level.normalized();
  return down.unitOrthogonal();
}

Eigen::Vector3d TurnedBy(const RigidTransform& motion, const Eigen::Vector3d& down,
                         const Eigen::Vector3d& direction) {
  const Eigen::Quaterniond q(motion.rotation());
  const double angle_rad = 2.0 * std::atan2(q.vec().dot(down), q.w());
  return Levelled(Eigen::AngleAxisd(angle_rad, down) * direction, down);
}

Eigen::Matrix3d BoxAxes(const Eigen::Vector3d& forward, const Eigen::Vector3d& down) {
  Eigen::Matrix3d axes;
  axes << forward, down, forward.cross(down);
  return axes;
}

std::optional<Eigen::Vector3d> DirectionOfMotion(const Cluster& cluster,
                                                 const Eigen::Vector3d& p_in_object,
                                                 const Eigen::Vector3d& down, double least_m) {
  const Eigen::Vector3d now = cluster.Latest().world_from_object * p_in_object;
  for (auto state = cluster.states.rbegin(); state != cluster.states.rend(); ++state) {
    const Eigen::Vector3d moved = now - state->world_from_object * p_in_object;
    const Eigen::Vector3d level = moved - down * down.dot(moved);
    if (level.norm() > least_m) return level.normalized();
  }
  return std::nullopt;
}

namespace {

constexpr int kHypotheses = 100;
constexpr std::size_t kLeastPoints = 20;
constexpr double kMostTilt_cos = 0.766;  // 40 degrees from the camera's y axis
// As a fraction of a point's distance; allows for triangulation errors and uneven ground.
constexpr double kTolerance = 0.01;
constexpr double kBelow = 3.0;  // in tolerances
// Points below the ground are outliers unless they exceed this fraction of the points on it.
constexpr double kMostBelow = 0.1;
constexpr double kKept = 0.95;  // decay factor of the sum of normals, per frame

struct Plane {
  Eigen::Vector3d down;     // unit vector
  double distance_m = 0.0;  // down . p of its points
};

struct Support {
  std::vector<std::size_t> on;
  int below = 0;

  double Score() const { return static_cast<double>(on.size()) - below / kMostBelow; }
};

std::optional<Plane> PlaneThrough(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c) {
  Eigen::Vector3d normal = (b - a).cross(c - a);
  if (!(normal.norm() > 1e-9)) return std::nullopt;
  normal.normalize();
  if (normal.y() < 0.0) normal = -normal;
  if (normal.y() < kMostTilt_cos) return std::nullopt;
  return Plane{normal, normal.dot(a)};
}

Support SupportOf(const Plane& plane, const std::vector<Eigen::Vector3d>& points) {
  Support support;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double below = (plane.down.dot(points[i]) - plane.distance_m) / points[i].norm();
    if (std::abs(below) <= kTolerance) support.on.push_back(i);
    if (below > kBelow * kTolerance) ++support.below;
  }
  return support;
}

// Returns the least-squares normal of the plane through the chosen points.
Eigen::Vector3d NormalOf(const std::vector<Eigen::Vector3d>& points,
                         const std::vector<std::size_t>& chosen) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::size_t i : chosen) mean += points[i] / static_cast<double>(chosen.size());
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (const std::size_t i : chosen) moment += (points[i] - mean) * (points[i] - mean).transpose();
  const Eigen::Vector3d normal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moment).eigenvectors().col(0);
  return normal.y() < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

}  // namespace

void GroundDirection::Update(std::span<const Eigen::Vector3d> points_in_world,
                             const RigidTransform& world_from_camera) {
  sum_ *= kKept;
  if (points_in_world.size() < kLeastPoints) return;
  const RigidTransform camera_from_world = world_from_camera.Inverse();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& p : points_in_world) points.push_back(camera_from_world * p);
  Support best;
  const auto any = [&] { return points[rng_.UniformInt(points.size())]; };
  for (int i = 0; i < kHypotheses; ++i) {
    const Eigen::Vector3d a = any();
    const Eigen::Vector3d b = any();
    const std::optional<Plane> plane = PlaneThrough(a, b, any());
    if (!plane) continue;
    Support support = SupportOf(*plane, points);
    if (best.on.empty() || support.Score() > best.Score()) best = std::move(support);
  }
  if (best.on.size() < kLeastPoints || best.Score() <= 0.0) return;
  sum_ += static_cast<double>(best.on.size()) *
          (world_from_camera.rotation() * NormalOf(points, best.on));
}

Eigen::Vector3d GroundDirection::Down(const RigidTransform& world_from_camera) const {
  constexpr double kForgotten = 1.0;  // in points
  if (sum_.norm() > kForgotten) return sum_.normalized();
  return world_from_camera.rotation() * Eigen::Vector3d::UnitY();
}

namespace {

constexpr double kNear_m = 0.5;  // least depth: where a box that reaches behind the camera ends

// Returns the landmarks seen in frame `newest`, in the camera frame.
std::vector<Eigen::Vector3d> SeenPoints(const FrameView& view, FrameId newest,
                                        const Cluster& cluster) {
  const RigidTransform camera_from_object =
      view.world_from_camera.Inverse() * cluster.Latest().world_from_object;
  std::vector<Eigen::Vector3d> points;
  for (const Landmark& landmark : cluster.landmarks) {
    if (landmark.last_seen != newest) continue;
    const Eigen::Vector3d p = camera_from_object * landmark.p_in_object;
    if (p.z() > kNear_m) points.push_back(p);
  }
  return points;
}

// Returns the rectangle around the projection of the box; `center` is in the camera frame.
ImageBox PictureOf(const StereoCamera& camera, const BoxShape& shape,
                   const Eigen::Vector3d& center) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ImageBox picture{kInfinity, kInfinity, -kInfinity, -kInfinity};
  for (unsigned i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign((i & 1U) != 0 ? 0.5 : -0.5, (i & 2U) != 0 ? 0.5 : -0.5,
                               (i & 4U) != 0 ? 0.5 : -0.5);
    const Eigen::Vector3d corner = center + shape.axes * shape.size_m.cwiseProduct(sign);
    const double depth_m = std::max(corner.z(), kNear_m);
    Include(camera.fx * corner.x() / depth_m + camera.cx,
            camera.fy * corner.y() / depth_m + camera.cy, picture);
  }
  return picture;
}

// How far a projection has to move to be centred, judged by those of two edges that are not cut.
// `at_low_px` and `at_high_px` are the shifts that would align each of these edges.
double EdgeShift(double at_low_px, double at_high_px, bool cuts_low, bool cuts_high) {
  if (cuts_low && cuts_high) return 0.0;
  if (cuts_low) return at_high_px;
  return cuts_high ? at_low_px : 0.5 * (at_low_px + at_high_px);
}

// Returns the centre moved such that the projection of the box is centred in the detection's box.
Eigen::Vector3d Centred(const StereoCamera& camera, const ImageBox& box, const BoxShape& seen,
                        const Eigen::Vector3d& center) {
  const ImageBox picture = PictureOf(camera, seen, center);
  const CutEdges cut = CutBy(camera, box);
  const double du_px = EdgeShift(box.left_px - picture.left_px, box.right_px - picture.right_px,
                                 cut.left, cut.right);
  const double dv_px = EdgeShift(box.top_px - picture.top_px, box.bottom_px - picture.bottom_px,
                                 cut.top, cut.bottom);
  const double depth_m = std::max(center.z(), kNear_m);
  return center + depth_m * Eigen::Vector3d(du_px / camera.fx, dv_px / camera.fy, 0.0);
}

// How far the point lies behind the face of the box that its ray meets first; empty if the ray
// misses the box.
std::optional<double> BehindSurface(const Eigen::Vector3d& p, const BoxShape& shape,
                                    const Eigen::Vector3d& center) {
  const Eigen::Vector3d ray = shape.axes.transpose() * p.normalized();
  const Eigen::Vector3d from_center = shape.axes.transpose() * -center;
  double enter_m = -std::numeric_limits<double>::infinity();
  double leave_m = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double half_m = 0.5 * shape.size_m[k];
    if (std::abs(ray[k]) < 1e-9) {
      if (std::abs(from_center[k]) > half_m) return std::nullopt;
      continue;
    }
    const double a = (-half_m - from_center[k]) / ray[k];
    const double b = (half_m - from_center[k]) / ray[k];
    enter_m = std::max(enter_m, std::min(a, b));
    leave_m = std::min(leave_m, std::max(a, b));
  }
  if (enter_m > leave_m) return std::nullopt;
  return p.norm() - enter_m;
}

// How far the foremost points lie behind the faces: nearly all points of a body are on its faces or
// behind them, such as those of a windscreen.
double SurfaceShift(const std::vector<Eigen::Vector3d>& points, const BoxShape& shape,
                    const Eigen::Vector3d& center) {
  std::vector<double> behind_m;
  for (const Eigen::Vector3d& p : points) {
    if (const auto one_m = BehindSurface(p, shape, center)) behind_m.push_back(*one_m);
  }
  constexpr std::size_t kLeast = 3;
  if (behind_m.size() < kLeast) return 0.0;
  // With fewer, a few wrong points decide; with more, boxes are too far.
  constexpr double kForemost = 0.3;
  const auto rank = static_cast<std::ptrdiff_t>(kForemost * static_cast<double>(behind_m.size()));
  std::nth_element(behind_m.begin(), behind_m.begin() + rank, behind_m.end());
  return behind_m[static_cast<std::size_t>(rank)];
}

bool IsDetected(const Cluster& cluster, FrameId newest) {
  return cluster.last_detected == newest && cluster.detection >= 0;
}

BoxShape InCamera(const FrameView& view, const BoxShape& shape) {
  return {view.world_from_camera.Inverse().RotationMatrix() * shape.axes, shape.size_m,
          shape.is_round};
}

BoxPlace PlaceAt(const FrameView& view, int detection, const BoxShape& shape,
                 const Eigen::Vector3d& center) {
  Eigen::Vector3d deviations = CenterDeviations(view, detection, shape.size_m.minCoeff());
  deviations.z() = std::hypot(deviations.z(),
                              DepthDeviation(view.camera, view.options.noise.disparity_px, center));
  return {view.world_from_camera * center,
          InformationAlong(view.world_from_camera, center, deviations)};
}

// Height of a body that looks `tall_m` tall along `down` (in its own axes): midway between that of
// a box, which is seen from corner to corner, and that of an ellipsoid with the same sides.
double HeightOf(double tall_m, const Eigen::Vector3d& down, const Eigen::Vector3d& size_m) {
  const double x_m = size_m.x() * std::abs(down.x());
  const double z_m = size_m.z() * std::abs(down.z());
  const double of_box_m = tall_m - x_m - z_m;
  const double of_round_m = std::sqrt(std::max(0.0, tall_m * tall_m - x_m * x_m - z_m * z_m));
  const double height_m = 0.5 * (of_box_m + of_round_m) / std::max(0.5, std::abs(down.y()));
  return std::max(height_m, 0.5 * size_m.y());
}

constexpr int kRounds = 5;

}  // namespace

double DepthDeviation(const StereoCamera& camera, double disparity_px, const Eigen::Vector3d& p) {
  return p.z() * p.z() / (camera.fx * camera.baseline_m) * disparity_px;
}

void ViewedSides::Add(double measured_m, double& side_m) {
  constexpr double kUp = 0.3;
  constexpr double kDown = 0.1;
  if (side_m == 0.0) side_m = measured_m;
  side_m += (measured_m > side_m ? kUp : kDown) * (measured_m - side_m);
}

std::optional<BoxPlace> PlaceBySurface(const FrameView& view, FrameId newest,
                                       const Cluster& cluster, const BoxShape& shape) {
  if (!IsDetected(cluster, newest)) return std::nullopt;
  const std::vector<Eigen::Vector3d> points = SeenPoints(view, newest, cluster);
  if (points.empty()) return std::nullopt;
  const BoxShape seen = InCamera(view, shape);
  Eigen::Vector3d center = MedianPoint(points);
  for (int i = 0; i < kRounds; ++i) {
    center = Centred(view.camera, view.shown.detections[cluster.detection].box, seen, center);
    center += SurfaceShift(points, seen, center) * center.normalized();
  }
  return PlaceAt(view, cluster.detection, shape, center);
}

std::optional<BoxPlace> PlaceByPicture(const FrameView& view, FrameId newest,
                                       const Cluster& cluster, const BoxShape& shape,
                                       const Eigen::Vector3d& center_in_world) {
  const Eigen::Vector3d center = view.world_from_camera.Inverse() * center_in_world;
  if (!IsDetected(cluster, newest) || center.z() < kNear_m) return std::nullopt;
  return PlaceAt(view, cluster.detection, shape,
                 Centred(view.camera, view.shown.detections[cluster.detection].box,
                         InCamera(view, shape), center));
}

void AddPicture(const FrameView& view, int detection, const BoxShape& shape,
                const Eigen::Vector3d& center_in_world, ViewedSides& viewed) {
  const ImageBox& box = view.shown.detections[detection].box;
  const CutEdges cut = CutBy(view.camera, box);
  const Eigen::Matrix3d axes = InCamera(view, shape).axes;
  const Eigen::Vector3d center = view.world_from_camera.Inverse() * center_in_world;
  const double depth_m = std::max(center.z(), kNear_m);
  const Eigen::Vector3d right = axes.col(1).cross(center).normalized();
  if (!cut.top && !cut.bottom) {
    const Eigen::Vector3d down = axes.transpose() * center.cross(right).normalized();
    const double tall_m = box.Height() * depth_m / view.camera.fy;
    viewed.Add(shape.is_round ? tall_m : HeightOf(tall_m, down, shape.size_m), viewed.height_m);
  }
  if (!cut.left && !cut.right) {
    const double wide_m = box.Width() * depth_m / view.camera.fx;
    const double by_corners = (right.transpose() * axes).cwiseAbs().sum();
    viewed.Add(shape.is_round ? wide_m : 0.5 * (wide_m / by_corners + wide_m), viewed.square_m);
  }
}

}  // namespace cvo
