// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/camera_metrics.h"

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

namespace {

using reports::MetricId;
using enum reports::MetricId;

// Numbers of frames, and what the contracts of all camera metrics share.
struct Frames {
  std::int64_t all = 0;
  std::int64_t with_truth = 0;
  std::int64_t common = 0;
  std::optional<reports::TruthSource> truth;

  Metric Make(MetricId id, double value, std::int64_t n) const {
    Metric metric = MakeMetric({id}, value, n);
    metric.contract.subject = reports::Subject::kCamera;
    metric.contract.truth = truth;
    metric.left_out = StrCat(all - with_truth, " of ", all, " frames without truth, ",
                             with_truth - common, " with truth but without an estimate");
    return metric;
  }
};

Metric Coverage(const Frames& frames) {
  Metric metric = frames.Make(
      kCameraCoverage, static_cast<double>(frames.common) / static_cast<double>(frames.with_truth),
      frames.with_truth);
  metric.left_out =
      StrCat(frames.all - frames.with_truth, " of ", frames.all, " frames without truth");
  return metric;
}

void AddAte(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const Eigen::Matrix3Xd offsets = AlignedPositionErrors(poses);
  std::vector<double> errors;
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();  // in the axes of the true camera
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d offset = offsets.col(static_cast<Eigen::Index>(i));
    errors.push_back(offset.norm());
    squares += (poses.truth[i].rotation().conjugate() * offset).cwiseAbs2();
  }
  const Eigen::Vector3d parts = (squares / static_cast<double>(poses.size())).cwiseSqrt();
  const auto add = [&](MetricId id, double value) {
    metrics.push_back(frames.Make(id, value, frames.common));
  };
  add(kCameraAte, RootMeanSquare(errors).value());
  add(kCameraAteMean, MeanOf(errors));
  add(kCameraAteMedian, Median(errors));
  add(kCameraAteMax, *std::max_element(errors.begin(), errors.end()));
  add(kCameraAteLateral, parts.x());
  add(kCameraAteVertical, parts.y());
  add(kCameraAteLongitudinal, parts.z());
}

void AddEndRotation(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const auto turn = [](const std::vector<RigidTransform>& of) {
    return of.front().rotation().conjugate() * of.back().rotation();
  };
  metrics.push_back(frames.Make(
      kCameraEndRotation, turn(poses.truth).angularDistance(turn(poses.estimate)), frames.common));
}

void AddRpe(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const auto add = [&](const RelativeErrors& errors, MetricId rotation, MetricId translation) {
    if (errors.rotation_rad) {
      metrics.push_back(frames.Make(rotation, *errors.rotation_rad, errors.pairs));
    }
    metrics.push_back(frames.Make(translation, errors.translation_m, errors.pairs));
    if (!errors.rotation_rad) {
      metrics.back().left_out +=
          StrCat("; rotations of all pairs: more than ", kMaxPairedRotations, " poses");
    }
  };
  if (const auto errors = AllPairsErrors(poses)) {
    add(*errors, kCameraRrpeAllPairs, kCameraTrpeAllPairs);
  }
  if (const auto errors = OneFrameErrors(poses)) {
    add(*errors, kCameraRrpe1Frame, kCameraTrpe1Frame);
  }
}

void AddPathError(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const auto lengths = ConsecutiveLengths(poses);
  if (!lengths || !(lengths->truth_m > 0.0)) return;
  metrics.push_back(frames.Make(kCameraPathError,
                                100.0 * std::abs(lengths->estimate_m / lengths->truth_m - 1.0),
                                lengths->pairs));
}

void AddDrift(const KittiDrift& drift, const Frames& frames, std::vector<Metric>& metrics) {
  const auto add = [&](MetricId id, double value) {
    metrics.push_back(frames.Make(id, value, drift.segments));
    metrics.back().left_out += StrCat("; ", drift.segments_without_estimate,
                                      " sub-sequences without an estimate at an end");
  };
  add(kCameraTDrift, drift.translation_percent);
  add(kCameraRDrift, drift.rotation_deg_per_100m);
}

void AddMaxDrift(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const auto drifts = MeasureMaxDrift(poses, AlignAtFirst(poses));
  if (!drifts) return;
  const std::array values = drifts->Values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    metrics.push_back(
        frames.Make(reports::MaxDriftMetric(kCameraMaxDrift, i), values[i], frames.common));
  }
}

}  // namespace

std::vector<Metric> EvaluateCamera(const OptionalPoses& truth, const OptionalPoses& estimate,
                                   std::optional<reports::TruthSource> source) {
  const CommonPoses poses = FindCommonPoses(truth, estimate);
  Frames frames;
  frames.all = static_cast<std::int64_t>(truth.size());
  frames.with_truth =
      std::count_if(truth.begin(), truth.end(), [](const auto& pose) { return pose.has_value(); });
  frames.common = static_cast<std::int64_t>(poses.size());
  frames.truth = source;

  std::vector<Metric> metrics;
  if (frames.with_truth > 0) metrics.push_back(Coverage(frames));
  if (frames.common < 2) return metrics;
  AddAte(poses, frames, metrics);
  AddEndRotation(poses, frames, metrics);
  AddRpe(poses, frames, metrics);
  if (const auto drift = ComputeKittiDrift(truth, estimate)) AddDrift(*drift, frames, metrics);
  AddPathError(poses, frames, metrics);
  AddMaxDrift(poses, frames, metrics);
  for (const Metric& metric : metrics) {
    if (!std::isfinite(metric.value)) ThrowError(metric.name, "an overflow", "a finite number");
  }
  return metrics;
}

std::vector<Metric> CompareTruths(const OptionalPoses& truth, const OptionalPoses& by_velocities,
                                  const OptionalPoses& estimate) {
  std::vector<Metric> metrics;
  const auto add = [&](MetricId id, const OptionalPoses& of) {
    const CommonPoses poses = FindCommonPoses(by_velocities, of);
    if (poses.size() < 2) return;
    metrics.push_back(MakeMetric(
        {id}, AlignedPositionErrors(poses).norm() / std::sqrt(static_cast<double>(poses.size())),
        static_cast<std::int64_t>(poses.size())));
    metrics.back().contract.subject = reports::Subject::kCamera;
    metrics.back().contract.truth = reports::TruthSource::kVelocities;
    metrics.back().left_out = StrCat(by_velocities.size() - poses.size(), " frames without both");
  };
  add(kCameraAteVelocity, estimate);
  add(kCameraTruthGap, truth);
  return metrics;
}

const Metric* FindMetric(const std::vector<Metric>& metrics, const std::string& name) {
  return FindBy(metrics, &Metric::name, name);
}

namespace {

// Mean squares over the image of the terms of FieldBasis, whose products have mean zero.
const Vector6d kMeanSquares{{1.0, 1.0 / 3.0, 1.0 / 3.0, 4.0 / 45.0, 1.0 / 9.0, 4.0 / 45.0}};

}  // namespace

std::vector<Metric> EvaluateCalibration(const Vector6d& true_field_px,
                                        const CalibrationReport& estimate) {
  if (!estimate.IsEstimated()) return {};
  const Vector6d error = estimate.right_field_px - true_field_px;
  const double claimed = error.dot(estimate.Covariance_px2().llt().solve(error));
  std::vector<Metric> metrics = {
      MakeMetric({reports::MetricId::kCalibrationError},
                 std::sqrt(error.cwiseAbs2().dot(kMeanSquares)), 1),
      MakeMetric({reports::MetricId::kCalibrationNees}, claimed / 6.0, 1)};
  for (Metric& metric : metrics) {
    metric.contract.subject = reports::Subject::kStereo;
    metric.contract.truth = reports::TruthSource::kScene;
    metric.left_out = "nothing";
  }
  return metrics;
}

namespace {

using reports::MaxDrift;

constexpr std::size_t kFirstFrames = 25;

// Absolute values of the angles about x, y and z, in this order.
Eigen::Vector3d RollPitchYaw(const RigidTransform& pose) {
  const Eigen::Matrix3d r = pose.RotationMatrix();
  return Eigen::Vector3d(std::atan2(r(2, 1), r(2, 2)),
                         std::atan2(-r(2, 0), std::hypot(r(2, 1), r(2, 2))),
                         std::atan2(r(1, 0), r(0, 0)))
      .cwiseAbs();
}

// Transforms from the body frame at the first pose to the body frame at each pose.
std::vector<RigidTransform> Motions(const std::vector<RigidTransform>& poses) {
  std::vector<RigidTransform> motions;
  for (const RigidTransform& pose : poses) motions.push_back(pose.Inverse() * poses.front());
  return motions;
}

// Motions since the first frame, and their error for a given alignment.
struct MotionPairs {
  std::vector<RigidTransform> truth;
  std::vector<RigidTransform> estimate;

  RigidTransform Error(std::size_t i, const RigidTransform& object_from_gtobject) const {
    return object_from_gtobject.Inverse() * estimate[i] * object_from_gtobject * truth[i].Inverse();
  }
};

struct NormalEquations {
  Matrix6d normal = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  double cost = 0.0;
};

// Linearises the errors in d for X Exp(d), in the frame of the true body, where they do not depend
// on the body frame of the estimate. The Jacobian of the rotation omits J_r^-1, which does not
// change the gradient.
NormalEquations Linearise(const MotionPairs& motions, std::size_t frames, const RigidTransform& X) {
  NormalEquations equations;
  for (std::size_t i = 1; i < frames; ++i) {
    const RigidTransform error = motions.Error(i, X);
    const Eigen::Matrix3d R = error.RotationMatrix();
    const Eigen::Matrix3d R_gt = motions.truth[i].RotationMatrix();
    Vector6d residual;
    residual << LogSo3(error.rotation()), error.translation();
    Matrix6d J = Matrix6d::Zero();
    J.topLeftCorner<3, 3>() = R_gt - R.transpose();
    J.bottomLeftCorner<3, 3>() =
        Skew(error.translation()) + R * Skew(motions.truth[i].translation()) * R_gt;
    J.bottomRightCorner<3, 3>() = R * R_gt - Eigen::Matrix3d::Identity();
    equations.normal += J.transpose() * J;
    equations.gradient += J.transpose() * residual;
    equations.cost += residual.squaredNorm();
  }
  return equations;
}

}  // namespace

// Levenberg-Marquardt, started from the closed-form alignment of the poses. A body that hardly
// turns leaves the translation undetermined; because of the damping, it stays at its start value.
RigidTransform AlignByMotions(const CommonPoses& poses, std::size_t frames) {
  constexpr int kSteps = 100;
  constexpr double kLeastDamping = 1e-9;
  constexpr double kDone = 1e-12;
  constexpr double kRounding = 1.0 + 1e-9;
  const MotionPairs motions = {Motions(poses.truth), Motions(poses.estimate)};
  CommonPoses first = poses;
  first.frames.resize(frames);
  RigidTransform X = AlignObject(first);
  RigidTransform best = X;
  NormalEquations at_best = Linearise(motions, frames, X);
  double damping = kLeastDamping;
  for (int step = 0; step < kSteps; ++step) {
    Matrix6d normal = at_best.normal;
    normal.diagonal().array() += damping * static_cast<double>(frames);
    const Vector6d tangent = -normal.ldlt().solve(at_best.gradient);
    if (!(tangent.norm() > kDone)) break;
    X = best * RigidTransform(ExpSo3(tangent.head<3>()), Eigen::Vector3d(tangent.tail<3>()));
    const NormalEquations equations = Linearise(motions, frames, X);
    const bool is_better = equations.cost <= kRounding * at_best.cost;
    damping = is_better ? std::max(0.1 * damping, kLeastDamping) : 10.0 * damping;
    if (!is_better) continue;
    best = X;
    at_best = equations;
  }
  return best;
}

namespace {

// Largest errors over all frames. The angles are separate maxima, or those of the frame in which
// they are largest together.
template <typename ErrorOf>
MaxDrift LargestOf(std::size_t frames, bool together, const ErrorOf& error_of) {
  double translation_m = 0.0;
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < frames; ++i) {
    const RigidTransform error = error_of(i);
    translation_m = std::max(translation_m, error.translation().norm());
    const Eigen::Vector3d here = RollPitchYaw(error);
    if (!together) angles = angles.cwiseMax(here);
    if (together && here.norm() > angles.norm()) angles = here;
  }
  return {translation_m, angles.x(), angles.y(), angles.z()};
}

MaxDrift DriftOfPoses(const CommonPoses& poses) {
  const RigidTransform object_from_gtobject = AlignObject(poses);
  return LargestOf(poses.size(), false, [&](std::size_t i) {
    return RigidTransform(poses.truth[i].Inverse() * poses.estimate[i] * object_from_gtobject);
  });
}

// After an alignment by the motions of the first `frames` poses.
MaxDrift DriftOfMotions(const CommonPoses& poses, std::size_t frames) {
  const MotionPairs motions = {Motions(poses.truth), Motions(poses.estimate)};
  const RigidTransform object_from_gtobject = AlignByMotions(poses, frames);
  return LargestOf(poses.size(), true,
                   [&](std::size_t i) { return motions.Error(i, object_from_gtobject); });
}

}  // namespace

RigidTransform AlignAtFirst(const CommonPoses& poses) {
  if (poses.size() == 0) return {};
  return poses.truth.front() * poses.estimate.front().Inverse();
}

std::optional<reports::MaxDrifts> MeasureMaxDrift(const CommonPoses& poses,
                                                  const RigidTransform& truth_from_estimate) {
  if (poses.size() < 2) return std::nullopt;
  CommonPoses moved = poses;
  for (RigidTransform& pose : moved.estimate) pose = truth_from_estimate * pose;
  return reports::MaxDrifts{DriftOfPoses(moved), DriftOfMotions(moved, poses.size()),
                            DriftOfMotions(moved, std::min(kFirstFrames, poses.size()))};
}

}  // namespace cvo
