// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/objects/object_scores.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

namespace {

// Common frames of a body and its cluster, with the estimate in the world of the truth.
struct BodyPoses {
  CommonPoses counted;
  std::vector<const ClusterFrame*> counted_frames;
  CommonPoses predicted;
};

void Add(int frame, const RigidTransform& truth, const RigidTransform& estimate,
         CommonPoses& poses) {
  poses.frames.push_back(frame);
  poses.truth.push_back(truth);
  poses.estimate.push_back(estimate);
}

BodyPoses CollectPoses(const TruthBody& body, const ClusterEstimate& cluster,
                       const RigidTransform& truth_from_estimate) {
  BodyPoses poses;
  for (const ClusterFrame& frame : cluster.frames) {
    const auto& truth = body.frames[static_cast<std::size_t>(frame.frame)];
    if (!truth) continue;
    const RigidTransform estimate = truth_from_estimate * frame.world_from_object;
    if (!Counts(frame)) {
      Add(frame.frame, truth->world_from_object, estimate, poses.predicted);
    } else if (truth->visible) {
      Add(frame.frame, truth->world_from_object, estimate, poses.counted);
      poses.counted_frames.push_back(&frame);
    }
  }
  return poses;
}

// Returns the true poses as seen by the true camera of their frame, placed at the estimated camera.
// The remaining error is that of the body alone, whatever the errors of the camera and its truth.
// Frames that lack either camera pose are left out.
CommonPoses AsSeen(const ObjectTruth& truth, const ObjectEstimate& estimate,
                   const RigidTransform& truth_from_estimate, const CommonPoses& poses) {
  CommonPoses seen;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto at = static_cast<std::size_t>(poses.frames[i]);
    const auto& of_truth = truth.world_from_camera[at];
    const auto& estimated = estimate.world_from_camera[at];
    if (!of_truth || !estimated) continue;
    Add(poses.frames[i], truth_from_estimate * *estimated * of_truth->Inverse() * poses.truth[i],
        poses.estimate[i], seen);
  }
  return seen;
}

void ApplyObject(const RigidTransform& object_from_gtobject, CommonPoses& poses) {
  for (RigidTransform& estimate : poses.estimate) estimate = estimate * object_from_gtobject;
}

reports::FrameErrors PositionErrors(const CommonPoses& poses,
                                    std::vector<Eigen::Vector3d>& positions) {
  reports::FrameErrors errors{poses.frames, {}};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    positions.push_back(poses.estimate[i].translation());
    errors.position_m.push_back((positions.back() - poses.truth[i].translation()).norm());
  }
  return errors;
}

void SetRelative(const std::optional<RelativeErrors>& errors, std::optional<double>& rotation_rad,
                 std::optional<double>& translation_m) {
  if (!errors) return;
  rotation_rad = errors->rotation_rad;
  translation_m = errors->translation_m;
}

// Velocity error at the point whose velocity the run gives, so that turning bodies are judged too.
std::optional<double> VelocityError(const ObjectTruth& truth, const TruthBody& body,
                                    const std::vector<const ClusterFrame*>& frames,
                                    const RigidTransform& gtobject_from_object,
                                    const RigidTransform& truth_from_estimate) {
  double sum = 0.0;
  std::size_t n = 0;
  for (const ClusterFrame* frame : frames) {
    const auto expected =
        PointVelocity(truth, body, frame->frame, gtobject_from_object * frame->point_in_object);
    if (!expected || !frame->velocity_m_s) continue;
    sum += (truth_from_estimate.rotation() * *frame->velocity_m_s - *expected).squaredNorm();
    ++n;
  }
  if (n == 0) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(n));
}

// Alignments of the world of the estimate to that of the truth.
struct Worlds {
  RigidTransform by_camera;
  RigidTransform by_first_pose;  // of the camera
};

void ScoreAsSeen(CommonPoses seen, BodyScore& score) {
  if (seen.size() == 0) return;
  ApplyObject(AlignObject(seen), seen);
  std::vector<Eigen::Vector3d> positions;
  score.ate_in_camera_m = RootMeanSquare(PositionErrors(seen, positions).position_m);
  if (const auto motion = MotionErrors(seen)) score.motion_in_camera_m = motion->translation_m;
}

constexpr int kJoinGap = 2;           // frames; longer gaps are losses
constexpr double kWrongJoin_m = 0.1;  // as far off as no success

// Counts how often the cluster returns after a gap, and how often the body's centre is then
// elsewhere in the cluster's frame. `poses` are those before AlignObject.
void CountJoins(const CommonPoses& poses, BodyScore& score) {
  Eigen::Vector3d former = Eigen::Vector3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (std::size_t i = 0; i <= poses.size(); ++i) {
    const bool ends = i == poses.size();
    if (ends || (i > 0 && poses.frames[i] - poses.frames[i - 1] > kJoinGap)) {
      const Eigen::Vector3d mean = sum / count;
      if (count < static_cast<int>(i)) {
        ++score.joins;
        if ((mean - former).norm() > kWrongJoin_m) ++score.wrong_joins;
      }
      former = mean;
      sum.setZero();
      count = 0;
    }
    if (ends) return;
    sum += poses.estimate[i].Inverse() * poses.truth[i].translation();
    ++count;
  }
}

void ScorePoses(const ObjectTruth& truth, const ObjectEstimate& estimate, const TruthBody& body,
                const ClusterEstimate& cluster, const Worlds& worlds, BodyScore& score) {
  BodyPoses poses = CollectPoses(body, cluster, worlds.by_camera);
  score.cluster = cluster.id;
  score.estimated_frames = static_cast<int>(poses.counted.size());
  if (poses.counted.size() == 0) return;
  score.max_drift =
      MeasureMaxDrift(poses.counted, worlds.by_first_pose * worlds.by_camera.Inverse());
  ScoreAsSeen(AsSeen(truth, estimate, worlds.by_camera, poses.counted), score);
  CountJoins(poses.counted, score);
  const RigidTransform object_from_gtobject = AlignObject(poses.counted);
  ApplyObject(object_from_gtobject, poses.counted);
  ApplyObject(object_from_gtobject, poses.predicted);
  score.errors = PositionErrors(poses.counted, score.estimated_positions);
  score.predicted = PositionErrors(poses.predicted, score.predicted_positions);
  score.ate_m = RootMeanSquare(score.errors.position_m);
  score.predicted_ate_m = RootMeanSquare(score.predicted.position_m);
  SetRelative(AllPairsErrors(poses.counted), score.all_pairs_rad, score.all_pairs_m);
  SetRelative(OneFrameErrors(poses.counted), score.one_frame_rad, score.one_frame_m);
  SetRelative(MotionErrors(poses.counted), score.motion_rad, score.motion_m);
  score.velocity_m_s = VelocityError(truth, body, poses.counted_frames,
                                     object_from_gtobject.Inverse(), worlds.by_camera);
}

BodyScore DescribeBody(const TruthBody& body, const Continuity& continuity) {
  BodyScore score;
  score.id = body.id;
  score.name = body.name;
  score.category = body.category;
  score.mover = body.mover;
  score.travel_m = body.travel_m;
  score.id_switches = continuity.id_switches;
  score.fragments = continuity.fragments;
  for (const auto& frame : body.frames) score.visible_frames += frame && frame->visible ? 1 : 0;
  return score;
}

bool CountsSomewhere(const ClusterEstimate& cluster) {
  return std::any_of(cluster.frames.begin(), cluster.frames.end(), Counts);
}

}  // namespace

RigidTransform AlignByCamera(const OptionalPoses& truth, const OptionalPoses& estimate) {
  const CommonPoses poses = FindCommonPoses(truth, estimate);
  if (poses.size() == 0) return {};
  Eigen::Matrix3d rotations = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    rotations += poses.truth[i].RotationMatrix() * poses.estimate[i].RotationMatrix().transpose();
  }
  const Eigen::Matrix3d R = NearestRotation(rotations);
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    t += poses.truth[i].translation() - R * poses.estimate[i].translation();
  }
  return {R, t / static_cast<double>(poses.size())};
}

ObjectScores ScoreObjects(const ObjectTruth& truth, const ObjectEstimate& estimate) {
  CheckEstimate(truth, estimate);
  ObjectScores scores;
  scores.match_by = estimate.match_by;
  scores.differentiated = estimate.differentiated;
  scores.truth_from_estimate = AlignByCamera(truth.world_from_camera, estimate.world_from_camera);
  const Worlds worlds = {
      scores.truth_from_estimate,
      AlignAtFirst(FindCommonPoses(truth.world_from_camera, estimate.world_from_camera))};
  const std::vector<ObjectMatch> matches = MatchObjects(truth, estimate);
  const std::vector<Continuity> continuity = MeasureContinuity(truth, estimate);
  auto match = matches.begin();
  for (std::size_t i = 0; i < truth.bodies.size(); ++i) {
    while (match != matches.end() && match->body < i) ++match;
    BodyScore score = DescribeBody(truth.bodies[i], continuity[i]);
    if (score.visible_frames == 0) continue;
    if (match != matches.end() && match->body == i) {
      ScorePoses(truth, estimate, truth.bodies[i], estimate.clusters[match->cluster], worlds,
                 score);
    }
    scores.bodies.push_back(std::move(score));
  }
  for (std::size_t c = 0; c < estimate.clusters.size(); ++c) {
    if (!CountsSomewhere(estimate.clusters[c])) continue;
    ++scores.clusters;
    const bool matched = std::any_of(matches.begin(), matches.end(),
                                     [&](const ObjectMatch& m) { return m.cluster == c; });
    scores.unmatched_clusters += matched ? 0 : 1;
  }
  return scores;
}

}  // namespace cvo
