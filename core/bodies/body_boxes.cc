// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/body_boxes.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "core/base/lists.h"
#include "core/bodies/body_place.h"

namespace cvo {

namespace {

struct Residuals {
  int seen = 0;
  double squared = 0.0;  // whitened, mean over the landmarks seen
};

Residuals ResidualsOf(const FeatureNoise& noise, const FrameView& view, FrameId newest,
                      const Cluster& cluster) {
  Residuals residuals;
  const ClusterState* state = FindState(cluster, newest);
  if (state == nullptr) return residuals;
  const RigidTransform camera_from_object =
      view.world_from_camera.Inverse() * state->world_from_object;
  for (const Landmark& landmark : cluster.landmarks) {
    const Observation* seen = FindObservation(landmark, newest);
    const auto z_px = view.camera.Project(camera_from_object * landmark.p_in_object);
    if (seen == nullptr || !z_px) continue;
    ++residuals.seen;
    residuals.squared += (noise.SqrtInformation(*seen) * (seen->z_px - *z_px)).squaredNorm();
  }
  if (residuals.seen > 0) residuals.squared /= residuals.seen;
  return residuals;
}

}  // namespace

double ScoreOf(const Options& options, const FrameView* view, FrameId newest,
               const Cluster& cluster) {
  const Residuals residuals = view == nullptr
                                  ? Residuals()
                                  : ResidualsOf(options.NoiseOfFeatures(), *view, newest, cluster);
  const double undetected = static_cast<double>(newest.value - cluster.last_detected.value);
  const double by_detector = 0.5 * (1.0 + cluster.score / (1.0 + std::abs(cluster.score)));
  const double by_age = cluster.detections / (cluster.detections + 1.0);
  const double by_landmarks =
      (residuals.seen + 1.0) / (residuals.seen + 1.0 + options.clusters.min_landmarks);
  const double by_residuals = 1.0 / (1.0 + residuals.squared / options.noise.gate);
  return by_detector * std::pow(ClusterOptions::kScoreDecay, undetected) * by_age * by_landmarks *
         by_residuals;
}

namespace {

constexpr Eigen::Index kFewPoints = 20;
constexpr int kAngles = 15;  // per right angle, in steps of 6 degrees

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

// Returns the range from `quantile`, which is small, to one minus it.
Interval OuterRange(Eigen::VectorXd values, double quantile) {
  const auto rank =
      static_cast<Eigen::Index>(std::lround(quantile * static_cast<double>(values.size() - 1)));
  const auto up_to_rank = values.begin() + rank + 1;
  std::partial_sort(values.begin(), up_to_rank, values.end());
  const double low = values[rank];
  std::partial_sort(values.begin(), up_to_rank, values.end(), std::greater());
  return {low, values[rank]};
}

Interval RangeAlong(const Eigen::Vector3d& axis, const Eigen::Matrix3Xd& points, double quantile) {
  return OuterRange((axis.transpose() * points).transpose(), quantile);
}

}  // namespace

Eigen::Matrix3d FootprintAxes(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& forward,
                              const Eigen::Vector3d& down) {
  if (points.cols() < kFewPoints) return BoxAxes(forward, down);
  const auto length_m = [&](const Eigen::Vector3d& axis) {
    const Interval range = RangeAlong(axis, points, kSideQuantile);
    return range.high - range.low;
  };
  Eigen::Vector3d best = forward;
  double least_m2 = std::numeric_limits<double>::infinity();
  // From -45 to 45 degrees, so that the best axis is the nearest to `forward` of its four
  // directions.
  for (int i = 0; i < kAngles; ++i) {
    const double angle_rad = std::numbers::pi / 2.0 * ((i + 0.5) / kAngles - 0.5);
    const Eigen::Vector3d axis = Eigen::AngleAxisd(angle_rad, down) * forward;
    const double area_m2 = length_m(axis) * length_m(axis.cross(down));
    if (area_m2 >= least_m2) continue;
    least_m2 = area_m2;
    best = axis;
  }
  return BoxAxes(best, down);
}

LandmarkSides SidesAlong(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points) {
  LandmarkSides sides;
  for (int k = 0; k < 3; ++k) {
    const Interval range = RangeAlong(axes.col(k), points, kSideQuantile);
    sides.low[k] = range.low;
    sides.high[k] = range.high;
    sides.size_m[k] = std::max(range.high - range.low, 2.0 * kMinHalfSize_m);
  }
  return sides;
}

Eigen::Vector3d WithPictures(const Eigen::Vector3d& size_m, const ViewedSides& viewed) {
  Eigen::Vector3d sides_m = size_m;
  if (viewed.height_m > 0.0) sides_m.y() = viewed.height_m;
  if (viewed.square_m > 0.0) {
    for (const int k : {0, 2}) {
      sides_m[k] = std::clamp(sides_m[k], viewed.square_m / kFootprintRatio,
                              viewed.square_m * kFootprintRatio);
    }
  }
  return sides_m;
}

Eigen::Vector3d SidesOfBall(const Eigen::Vector3d& size_m, const ViewedSides& viewed) {
  const double viewed_m = std::max(viewed.height_m, viewed.square_m);
  return Eigen::Vector3d::Constant(viewed_m > 0.0 ? viewed_m : size_m.maxCoeff());
}

Eigen::Vector3d CenterBehindNearSides(const LandmarkSides& sides, const BoxShape& shape,
                                      const Eigen::Vector3d& camera_in_world) {
  const Eigen::Vector3d camera = shape.axes.transpose() * camera_in_world;
  Eigen::Vector3d center = 0.5 * (sides.low + sides.high);
  for (int k = 0; k < 3; ++k) {
    const double unseen_m = 0.5 * (shape.size_m[k] - (sides.high[k] - sides.low[k]));
    // From between the planes of the two sides, the camera sees neither better than the other.
    if (camera[k] < sides.low[k]) center[k] += unseen_m;
    if (camera[k] > sides.high[k]) center[k] -= unseen_m;
  }
  return shape.axes * center;
}

CutEdges CutBy(const StereoCamera& camera, const ImageBox& box) {
  const double u_px = kBorder * box.Width();
  const double v_px = kBorder * box.Height();
  CutEdges cut;
  cut.left = box.left_px < u_px;
  cut.top = box.top_px < v_px;
  cut.right = box.right_px > camera.width_px - 1 - u_px;
  cut.bottom = box.bottom_px > camera.height_px - 1 - v_px;
  return cut;
}

Eigen::Vector3d CenterDeviations(const FrameView& view, int detection, double size_m) {
  // Another body may hide any edge of the box.
  const ImageBox& box = view.shown.detections[detection].box;
  bool is_hidden = false;
  for (int m = 0; m < static_cast<int>(view.shown.detections.size()); ++m) {
    is_hidden |= m != detection && ShareInside(box, view.shown.detections[m].box) > kMaxOverlap;
  }
  const CutEdges cut = CutBy(view.camera, box);
  const auto deviation = [](bool unseen) { return unseen ? kUnseenDeviation : kEdgeDeviation; };
  return size_m * Eigen::Vector3d(deviation(is_hidden || cut.left || cut.right),
                                  deviation(is_hidden || cut.top || cut.bottom), kUnseenDeviation);
}

Eigen::Matrix3d InformationAlong(const RigidTransform& world_from_camera,
                                 const Eigen::Vector3d& ray, const Eigen::Vector3d& deviations_m) {
  // Axes of a camera that looks along the ray.
  const Eigen::Matrix3d R =
      world_from_camera.RotationMatrix() *
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), ray).toRotationMatrix();
  return R * deviations_m.cwiseAbs2().cwiseInverse().asDiagonal() * R.transpose();
}

void CenterEstimate::Add(const RigidTransform& object_from_there,
                         const Eigen::Vector3d& center_there,
                         const Eigen::Matrix3d& information_there) {
  const Eigen::Matrix3d R = object_from_there.RotationMatrix();
  const Eigen::Matrix3d added = R * information_there * R.transpose();
  information += added;
  weighted += added * (object_from_there * center_there);
  ++boxes;
}

void CenterEstimate::Loosen(const Eigen::Matrix3d& covariance_m2) {
  if (boxes == 0) return;
  const Eigen::Vector3d center = InObject();
  information = (information.inverse() + covariance_m2).inverse();
  weighted = information * center;
}

Eigen::Vector3d CenterEstimate::InObject() const {
  if (boxes == 0) return Eigen::Vector3d::Zero();
  return information.llt().solve(weighted);
}

namespace {

// Returns the cluster's landmarks in world, at the time of its latest state; its origin if it has
// no landmarks.
Eigen::Matrix3Xd PointsOf(const Cluster& cluster) {
  const RigidTransform& world_from_object = cluster.Latest().world_from_object;
  if (cluster.landmarks.empty()) return world_from_object.translation();
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(cluster.landmarks.size()));
  for (std::size_t i = 0; i < cluster.landmarks.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = world_from_object * cluster.landmarks[i].p_in_object;
  }
  return points;
}

// Advances the track to the cluster's latest state.
void Follow(const BoxScene& scene, const Cluster& cluster, BodyTrack& track) {
  const ClusterState& latest = cluster.Latest();
  if (!track.frame.valid()) {
    track.forward =
        Levelled(scene.world_from_camera.rotation() * Eigen::Vector3d::UnitZ(), scene.down);
  } else {
    const ClusterState* before = FindState(cluster, track.frame);
    const RigidTransform& then = before ? before->world_from_object : track.world_from_object;
    track.forward = TurnedBy(latest.world_from_object * then.Inverse(), scene.down, track.forward);
  }
  track.frame = latest.frame;
  track.world_from_object = latest.world_from_object;
}

void TurnToMotion(const BoxScene& scene, const Cluster& cluster, BodyTrack& track) {
  const Eigen::Vector3d at = cluster.Latest().world_from_object * cluster.center_in_object;
  const double least_m = scene.options.boxes.heading_deviations *
                         DepthDeviation(scene.view->camera, scene.options.noise.disparity_px,
                                        scene.world_from_camera.Inverse() * at);
  const auto direction = DirectionOfMotion(cluster, cluster.center_in_object, scene.down, least_m);
  if (direction) track.forward = *direction;
}

// Sets axes and sides. `known_m` is 0 for sides that are estimated from landmarks and images.
void ShapeBox(const BoxScene& scene, const Cluster& cluster, const Eigen::Vector3d& known_m,
              BodyTrack& track) {
  const Eigen::Matrix3Xd points = PointsOf(cluster);
  const bool is_known = known_m.minCoeff() > 0.0;
  track.shape.axes = is_known ? BoxAxes(track.forward, scene.down)
                              : FootprintAxes(points, track.forward, scene.down);
  const LandmarkSides sides = SidesAlong(track.shape.axes, points);
  track.shape.is_round = IsRound(cluster.category);
  const Eigen::Vector3d size_m = track.shape.is_round ? SidesOfBall(sides.size_m, track.viewed)
                                                      : WithPictures(sides.size_m, track.viewed);
  track.shape.size_m = (known_m.array() > 0.0).select(known_m, size_m);
  const Eigen::Vector3d camera = scene.world_from_camera.translation();
  track.landmark_center = CenterBehindNearSides(sides, track.shape, camera);
}

// Covariance, in the object frame, of a single triangulated point of the body; zero beside or
// behind the camera.
Eigen::Matrix3d CovarianceInObject(const BoxScene& scene, const RigidTransform& object_from_world,
                                   const Eigen::Vector3d& p_in_world) {
  const StereoCamera& camera = scene.view->camera;
  const auto z_px = camera.Project(scene.world_from_camera.Inverse() * p_in_world);
  if (!z_px) return Eigen::Matrix3d::Zero();
  const Eigen::Matrix3d R = (object_from_world * scene.world_from_camera).RotationMatrix();
  return R * camera.PointCovariance(*z_px, scene.options.NoiseOfFeatures().Covariance(0)) *
         R.transpose();
}

// Updates the body's place, and for later frames its sides, from its view in this frame.
void LookAt(const BoxScene& scene, const Cluster& cluster, bool is_known, BodyTrack& track) {
  const std::optional<BoxPlace> place =
      is_known
          ? PlaceBySurface(*scene.view, scene.newest, cluster, track.shape)
          : PlaceByPicture(*scene.view, scene.newest, cluster, track.shape, track.landmark_center);
  if (!place) return;
  const RigidTransform object_from_world = cluster.Latest().world_from_object.Inverse();
  track.center.Loosen(CovarianceInObject(scene, object_from_world, place->center_in_world));
  track.center.Add(object_from_world, place->center_in_world, place->information);
  if (!is_known) {
    AddPicture(*scene.view, cluster.detection, track.shape, place->center_in_world, track.viewed);
  }
}

// Returns the box at the reported pose of the body, which is predicted if the body was not found.
BodyBox BoxAt(const BoxScene& scene, const Cluster& cluster, const BodyTrack& track,
              const RigidTransform& world_from_object) {
  const RigidTransform& latest = cluster.Latest().world_from_object;
  const RigidTransform motion = world_from_object * latest.Inverse();
  const Eigen::Vector3d center =
      track.center.boxes > 0 ? latest * track.center.InObject() : track.landmark_center;
  const Eigen::Matrix3d axes =
      BoxAxes(TurnedBy(motion, scene.down, track.shape.axes.col(0)), scene.down);
  return {world_from_object.Inverse() * RigidTransform(axes, motion * center), track.shape.size_m};
}

}  // namespace

void BodyBoxes::Describe(const BoxScene& scene, std::vector<ClusterReport>& reports) {
  for (std::size_t q = 0; q < scene.clusters.live.size(); ++q) {
    const Cluster& cluster = scene.clusters.live[q];
    BodyTrack& track = tracks_[cluster.id];
    const Eigen::Vector3d known_m = SizeOfClass(cluster.category);
    Follow(scene, cluster, track);
    const bool is_seen = scene.view != nullptr && cluster.Latest().frame == scene.newest;
    if (is_seen) {
      TurnToMotion(scene, cluster, track);
      ShapeBox(scene, cluster, known_m, track);
      LookAt(scene, cluster, known_m.minCoeff() > 0.0, track);
    }
    reports[q].box = BoxAt(scene, cluster, track, reports[q].world_from_object);
    reports[q].score = ScoreOf(scene.options, scene.view, scene.newest, cluster);
  }
  // Forget removed clusters.
  std::erase_if(tracks_, [&](const auto& track) {
    return FindBy(scene.clusters.live, &Cluster::id, track.first) == nullptr;
  });
}

}  // namespace cvo
