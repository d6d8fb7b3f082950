// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/record/metric_catalogue.h"
#include "core/record/run_summary.h"

namespace cvo {

using Metric = reports::MetricValue;

// Makes a metric with the name and unit of the catalogue, and the part of the contract that the
// catalogue determines.
inline Metric MakeMetric(const reports::MetricForm& form, double value, std::int64_t n) {
  return {reports::MetricName(form), value, reports::EntryOf(form.id).unit, n,
          reports::RelationOf(form), ""};
}

// Enters into the contracts which poses were evaluated (causal, refined or from a file), and by how
// much the published calibration was changed for them.
inline void StatePoses(reports::PoseTime poses, double right_shift_px,
                       std::vector<Metric>& metrics) {
  for (Metric& metric : metrics) {
    metric.contract.poses = poses;
    metric.contract.right_shift_px = right_shift_px;
  }
}

using OptionalPoses = std::vector<std::optional<RigidTransform>>;

// Frames that have both a true and an estimated pose world_from_x.
struct CommonPoses {
  std::vector<int> frames;  // increasing
  std::vector<RigidTransform> truth;
  std::vector<RigidTransform> estimate;

  std::size_t size() const { return frames.size(); }
};
// Throws Error if the lengths differ or a pose is not finite.
CommonPoses FindCommonPoses(const OptionalPoses& truth, const OptionalPoses& estimate);

// Positions of the poses, one per column.
Eigen::Matrix3Xd Positions(const std::vector<RigidTransform>& poses);

// Position errors (m) after the SE(3) alignment of the estimated positions to the true ones, one
// per column.
Eigen::Matrix3Xd AlignedPositionErrors(const CommonPoses& poses);

// Root mean squares of E = (G_i^-1 G_j)^-1 (P_i^-1 P_j) over pairs of frames.
struct RelativeErrors {
  std::optional<double> rotation_rad;
  double translation_m = 0.0;
  std::int64_t pairs = 0;
};
// Largest number of poses for which the rotations of all pairs are computed. Unlike the
// translations, they have no closed-form sum, so beyond this it takes too long.
inline constexpr std::size_t kMaxPairedRotations = 100'000;
// Over all ordered pairs i != j; empty for fewer than two poses. Beyond kMaxPairedRotations poses,
// rotation_rad is empty.
[[nodiscard]] std::optional<RelativeErrors> AllPairsErrors(const CommonPoses& poses);
// Over the pairs (i, i + 1) of consecutive frames; empty if there are none.
[[nodiscard]] std::optional<RelativeErrors> OneFrameErrors(const CommonPoses& poses);
// The same for motions in the world, which do not depend on the choice of the body frame:
//   E = G_i^-1 (G_j G_i^-1)^-1 (P_j P_i^-1) G_i.
[[nodiscard]] std::optional<RelativeErrors> MotionErrors(const CommonPoses& poses);

// Lengths of the paths over the pairs (i, i + 1) of consecutive frames; empty if there are none.
struct ComparedPaths {
  double truth_m = 0.0;
  double estimate_m = 0.0;
  std::int64_t pairs = 0;
};
[[nodiscard]] std::optional<ComparedPaths> ConsecutiveLengths(const CommonPoses& poses);

// Drift as defined by the KITTI odometry devkit: the mean error of the relative pose, per metre,
// over sub-sequences of 100, 200, ..., 800 m along the true path that start at every tenth frame.
struct KittiDrift {
  double translation_percent = 0.0;
  double rotation_deg_per_100m = 0.0;
  std::int64_t segments = 0;
  std::int64_t segments_without_estimate = 0;
};
// Empty if no sub-sequence has an estimate at both ends. The path across frames without truth is
// taken as a straight line; a sub-sequence whose first frame has no truth is left out.
[[nodiscard]] std::optional<KittiDrift> ComputeKittiDrift(const OptionalPoses& truth,
                                                          const OptionalPoses& estimate);

}  // namespace cvo
