// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/truth_file.h"

#include "core/record/truth.h"

namespace cvo {
namespace {

reports::Pose PoseOf(const RigidTransform& pose) {
  const auto t = pose.translation();
  const auto q = pose.rotation();
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

reports::TruthPoses PosesOf(const TruthBody& body, const RigidTransform& estimate_from_truth) {
  reports::TruthPoses poses;
  for (std::size_t i = 0; i < body.frames.size(); ++i) {
    if (!body.frames[i]) continue;
    poses.frames.push_back(static_cast<int>(i));
    poses.poses.push_back(PoseOf(estimate_from_truth * body.frames[i]->world_from_object));
    poses.visible.push_back(body.frames[i]->visible);
  }
  return poses;
}

reports::FramePositions PositionsOf(const reports::FrameErrors& errors,
                                    const std::vector<Eigen::Vector3d>& estimates,
                                    const RigidTransform& estimate_from_truth) {
  reports::FramePositions positions{errors.frames, {}};
  for (const Eigen::Vector3d& estimate : estimates) {
    const Eigen::Vector3d p = estimate_from_truth * estimate;
    positions.positions_m.push_back({p.x(), p.y(), p.z()});
  }
  return positions;
}

reports::TruthOfBody BodyOf(const BodyScore& score, const TruthBody& body,
                            const RigidTransform& estimate_from_truth) {
  reports::TruthOfBody truth;
  truth.id = score.id;
  truth.name = score.name;
  truth.category = score.category;
  truth.mover = score.mover;
  truth.diagonal_m = body.diagonal_m;
  truth.cluster = score.cluster;
  truth.truth = PosesOf(body, estimate_from_truth);
  truth.estimated = PositionsOf(score.errors, score.estimated_positions, estimate_from_truth);
  truth.predicted = PositionsOf(score.predicted, score.predicted_positions, estimate_from_truth);
  return truth;
}

}  // namespace

std::string TruthFile(const std::string& job, const TruthRecord& truth) {
  const RigidTransform estimate_from_truth = truth.truth_from_estimate.Inverse();
  reports::TruthData data;
  data.job = job;
  if (truth.camera) {
    for (const auto& world_from_camera : *truth.camera) {
      data.camera.emplace_back();
      if (world_from_camera) data.camera.back() = PoseOf(estimate_from_truth * *world_from_camera);
    }
  }
  if (truth.objects && truth.bodies) {
    for (const BodyScore& score : *truth.bodies) {
      data.bodies.push_back(
          BodyOf(score, *FindBody(*truth.objects, score.id), estimate_from_truth));
    }
  }
  return FileText(data);
}

}  // namespace cvo
