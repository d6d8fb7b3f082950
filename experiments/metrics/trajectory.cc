// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json_record.h"

namespace cvo {

std::optional<RigidTransform> InterpolatePose(const Trajectory& trajectory, std::int64_t time_ns) {
  const auto after = std::lower_bound(
      trajectory.begin(), trajectory.end(), time_ns,
      [](const TimedPose& pose, std::int64_t time) { return pose.timestamp_ns < time; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->timestamp_ns == time_ns) return after->world_from_camera;
  if (after == trajectory.begin()) return std::nullopt;
  const TimedPose& a = *(after - 1);
  const TimedPose& b = *after;
  const double s = static_cast<double>(time_ns - a.timestamp_ns) /
                   static_cast<double>(b.timestamp_ns - a.timestamp_ns);
  return RigidTransform(
      a.world_from_camera.rotation().slerp(s, b.world_from_camera.rotation()),
      (1.0 - s) * a.world_from_camera.translation() + s * b.world_from_camera.translation());
}

namespace {

// A time of either list among the times of both.
struct MergedTime {
  std::int64_t time_ns;
  bool of_b;
  std::size_t index;
  std::size_t before, after;  // the untaken ones next to it; kEnd: none
};
constexpr std::size_t kEnd = SIZE_MAX;

std::vector<MergedTime> Merge(const Times& a, const Times& b) {
  std::vector<MergedTime> all;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const bool of_b = i == a.size() || (j < b.size() && b[j] < a[i]);
    const std::size_t at = all.size();
    all.push_back({of_b ? b[j] : a[i], of_b, of_b ? j : i, at == 0 ? kEnd : at - 1, at + 1});
    ++(of_b ? j : i);
  }
  if (!all.empty()) all.back().after = kEnd;
  return all;
}

void CheckIncreasing(const Times& times) {
  Require(std::ranges::adjacent_find(times, std::ranges::greater_equal()) == times.end(),
          "AssociateByTime: timestamps must increase");
}

}  // namespace

Times TimesOf(const Trajectory& trajectory) {
  Times times;
  for (const TimedPose& pose : trajectory) times.push_back(pose.timestamp_ns);
  return times;
}

// The nearest pair of untaken times is always next to each other among the untaken ones.
TimeAssociation AssociateByTime(const Times& a, const Times& b, std::int64_t tolerance_ns) {
  Require(tolerance_ns >= 0, "AssociateByTime: the tolerance must not be negative");
  CheckIncreasing(a);
  CheckIncreasing(b);
  std::vector<MergedTime> all = Merge(a, b);
  // Distance, index in a, index in b, and where these are in `all`.
  using Pair = std::tuple<std::int64_t, std::size_t, std::size_t, std::size_t, std::size_t>;
  std::priority_queue<Pair, std::vector<Pair>, std::greater<>> nearest;
  const auto offer = [&](std::size_t first, std::size_t second) {
    if (first == kEnd || second == kEnd || all[first].of_b == all[second].of_b) return;
    const std::int64_t distance_ns = all[second].time_ns - all[first].time_ns;
    const std::size_t in_a = all[first].of_b ? second : first;
    const std::size_t in_b = all[first].of_b ? first : second;
    if (distance_ns > tolerance_ns) return;
    nearest.emplace(distance_ns, all[in_a].index, all[in_b].index, first, second);
  };
  for (std::size_t i = 1; i < all.size(); ++i) offer(i - 1, i);
  std::vector<bool> taken(all.size());
  TimeAssociation association;
  while (!nearest.empty()) {
    const auto [distance_ns, i, j, first, second] = nearest.top();
    nearest.pop();
    if (taken[first] || taken[second]) continue;
    taken[first] = taken[second] = true;
    association.pairs.emplace_back(i, j);
    const std::size_t before = all[first].before;
    const std::size_t after = all[second].after;
    if (before != kEnd) all[before].after = after;
    if (after != kEnd) all[after].before = before;
    offer(before, after);
  }
  std::sort(association.pairs.begin(), association.pairs.end());
  association.unmatched_a = a.size() - association.pairs.size();
  association.unmatched_b = b.size() - association.pairs.size();
  return association;
}

TimeAssociation AssociateByTime(const Trajectory& a, const Trajectory& b,
                                std::int64_t tolerance_ns) {
  return AssociateByTime(TimesOf(a), TimesOf(b), tolerance_ns);
}

std::vector<std::optional<RigidTransform>> PosesAtFrames(const TimeAssociation& truth_estimate,
                                                         std::size_t truth_frames,
                                                         const Trajectory& estimate) {
  std::vector<std::optional<RigidTransform>> poses(truth_frames);
  for (const auto& [frame, index] : truth_estimate.pairs) {
    Require(frame < truth_frames && index < estimate.size(), "PosesAtFrames: index out of range");
    poses[frame] = estimate[index].world_from_camera;
  }
  return poses;
}

namespace {

// The rotation does not depend on the scale, which then has a closed form.
Similarity AlignWithScale(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
  const Eigen::Matrix3d R = AlignPoints(from, to).RotationMatrix();
  const Eigen::Vector3d from_mean = from.rowwise().mean();
  const Eigen::Vector3d to_mean = to.rowwise().mean();
  const Eigen::Matrix3Xd from_centred = from.colwise() - from_mean;
  const Eigen::Matrix3Xd to_centred = to.colwise() - to_mean;
  const double scale = to_centred.cwiseProduct(R * from_centred).sum() / from_centred.squaredNorm();
  if (!(scale > 0.0) || !std::isfinite(scale)) {
    ThrowError("alignment sim3", "positions that determine no scale", "a trajectory that moves");
  }
  return {scale, RigidTransform(R, to_mean - scale * (R * from_mean))};
}

Similarity AlignYaw(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                    const Eigen::Vector3d& up) {
  const Eigen::Vector3d from_mean = from.rowwise().mean();
  const Eigen::Vector3d to_mean = to.rowwise().mean();
  double sine = 0.0;
  double cosine = 0.0;
  for (Eigen::Index i = 0; i < from.cols(); ++i) {
    const Eigen::Vector3d a = from.col(i) - from_mean;
    const Eigen::Vector3d b = to.col(i) - to_mean;
    sine += up.dot(a.cross(b));
    cosine += a.dot(b) - up.dot(a) * up.dot(b);
  }
  const Eigen::Quaterniond R(Eigen::AngleAxisd(std::atan2(sine, cosine), up));
  return {1.0, RigidTransform(R, to_mean - R * from_mean)};
}

}  // namespace

TrajectoryAlignment ParseTrajectoryAlignment(const std::string& text) {
  if (const auto alignment = EnumOf<TrajectoryAlignment>(text)) return *alignment;
  ThrowError("alignment", text, "one of: " + Joined(EnumNames(TrajectoryAlignment()), ", "));
}

std::string DescriptionOf(TrajectoryAlignment alignment) {
  constexpr std::array kDescriptions = {"not aligned", "aligned by SE(3) over positions",
                                        "aligned by Sim(3) over positions, with scale",
                                        "aligned at the first common pose",
                                        "aligned by yaw and translation over positions"};
  return kDescriptions.at(static_cast<std::size_t>(alignment));
}

Similarity AlignTrajectory(const CommonPoses& poses, TrajectoryAlignment alignment,
                           const Eigen::Vector3d& up) {
  if (poses.size() == 0) ThrowError("alignment", "no common poses", "at least one");
  const Eigen::Matrix3Xd from = Positions(poses.estimate);
  const Eigen::Matrix3Xd to = Positions(poses.truth);
  switch (alignment) {
    case TrajectoryAlignment::kNone:
      return {};
    case TrajectoryAlignment::kSe3:
      return {1.0, AlignPoints(from, to)};
    case TrajectoryAlignment::kSim3:
      return AlignWithScale(from, to);
    case TrajectoryAlignment::kOrigin:
      return {1.0, poses.truth.front() * poses.estimate.front().Inverse()};
    case TrajectoryAlignment::kYaw:
      return AlignYaw(from, to, up);
  }
  throw Error("TrajectoryAlignment: not one of the enumerators");
}

std::vector<double> OrientationErrors(const CommonPoses& poses, TrajectoryAlignment alignment,
                                      const Similarity& truth_from_estimate) {
  Eigen::Matrix3d R = truth_from_estimate.rigid.RotationMatrix();
  if (alignment == TrajectoryAlignment::kSe3 || alignment == TrajectoryAlignment::kSim3) {
    R.setZero();
    for (std::size_t i = 0; i < poses.size(); ++i) {
      R += poses.truth[i].RotationMatrix() * poses.estimate[i].RotationMatrix().transpose();
    }
    R = NearestRotation(R);
  }
  const Eigen::Quaterniond turned(R);
  std::vector<double> errors;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    errors.push_back(RotationAngle(Eigen::Quaterniond(poses.truth[i].rotation().conjugate() *
                                                      (turned * poses.estimate[i].rotation()))));
  }
  return errors;
}

RigidTransform AlignObject(const CommonPoses& poses) {
  Require(poses.size() > 0, "AlignObject: needs a pair of poses");
  Eigen::Matrix3d rotations = Eigen::Matrix3d::Zero();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const RigidTransform object_from_gtobject = poses.estimate[i].Inverse() * poses.truth[i];
    rotations += object_from_gtobject.RotationMatrix();
    t += object_from_gtobject.translation();
  }
  return {NearestRotation(rotations), t / static_cast<double>(poses.size())};
}

}  // namespace cvo
