// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/interface/frame.h"
#include "core/record/body_row.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

// Computes the camera metrics of one run, in a fixed order: camera_coverage, camera_ate (root mean
// square) with _mean, _median, _max and its parts, camera_end_rotation, camera_{r,t}rpe_all_pairs,
// camera_{r,t}rpe_1_frame, camera_{t,r}_drift, and camera_max_drift with its angles under each of
// three contracts. Poses are world_from_camera per frame, empty if there is none; both lists have
// the same length. A metric that the frames do not determine is absent. `source` enters the
// contracts. Throws Error if a pose is not finite.
std::vector<Metric> EvaluateCamera(const OptionalPoses& truth, const OptionalPoses& estimate,
                                   std::optional<reports::TruthSource> source = {});

// Computes camera_ate_velocity, of the estimate against positions integrated from velocities, and
// camera_truth_gap, of the truth against these. Lists as for EvaluateCamera; a metric whose list is
// empty is absent.
std::vector<Metric> CompareTruths(const OptionalPoses& truth, const OptionalPoses& by_velocities,
                                  const OptionalPoses& estimate);

// Returns the metric of this name; nullptr if it is absent.
const Metric* FindMetric(const std::vector<Metric>& metrics, const std::string& name);

// Measures self-calibration against the true coefficients of StereoCamera::right_field_px:
// calibration_error and calibration_nees. Empty if it was not estimated.
std::vector<Metric> EvaluateCalibration(const Vector6d& true_field_px,
                                        const CalibrationReport& estimate);

// Computes the largest errors over a run under the three contracts of reports::Alignment
// (METHOD.md 10.5). `truth_from_estimate` aligns the worlds for kAllPoses. The result does not
// depend on the body frame of the estimate: P_t B in place of P_t, with B constant, gives the same.
// Empty for fewer than two poses.
[[nodiscard]] std::optional<reports::MaxDrifts> MeasureMaxDrift(
    const CommonPoses& poses, const RigidTransform& truth_from_estimate);

// Returns X (object_from_gtobject) of the contracts by motions, from the first `frames` poses.
RigidTransform AlignByMotions(const CommonPoses& poses, std::size_t frames);

// Returns truth_from_estimate such that the first common poses coincide; the identity if there is
// none.
RigidTransform AlignAtFirst(const CommonPoses& poses);

}  // namespace cvo
