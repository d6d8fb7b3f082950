// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/truth_file.h"

#include "core/files/json.h"
#include "experiments/record/result_file.h"

namespace cvo {
namespace {

constexpr int kSchemaVersion = 1;

Json CameraToJson(const OptionalPoses& camera, const RigidTransform& estimate_from_truth) {
  Json poses = Json::array();
  for (const auto& world_from_camera : camera) {
    poses.push_back(world_from_camera ? PoseToJson(estimate_from_truth * *world_from_camera)
                                      : Json(nullptr));
  }
  return poses;
}

Json TruthToJson(const TruthBody& body, const RigidTransform& estimate_from_truth) {
  Json frames = Json::array();
  Json poses = Json::array();
  Json visible = Json::array();
  for (std::size_t i = 0; i < body.frames.size(); ++i) {
    if (!body.frames[i]) continue;
    frames.push_back(i);
    poses.push_back(PoseToJson(estimate_from_truth * body.frames[i]->world_from_object));
    visible.push_back(body.frames[i]->visible);
  }
  return {{"frames", frames}, {"poses", poses}, {"visible", visible}};
}

Json PositionsToJson(const std::vector<ObjectFrameError>& errors,
                     const RigidTransform& estimate_from_truth) {
  Json frames = Json::array();
  Json positions_m = Json::array();
  for (const ObjectFrameError& error : errors) {
    const Eigen::Vector3d p = estimate_from_truth * error.estimate;
    frames.push_back(error.frame);
    positions_m.push_back({p.x(), p.y(), p.z()});
  }
  return {{"frames", frames}, {"positions_m", positions_m}};
}

Json BodiesToJson(const TruthRecord& truth, const RigidTransform& estimate_from_truth) {
  Json bodies = Json::array();
  for (const BodyScore& score : *truth.bodies) {
    const TruthBody& body = *FindBody(*truth.objects, score.id);
    bodies.push_back({{"id", score.id},
                      {"name", score.name},
                      {"category", score.category},
                      {"mover", score.mover},
                      {"diagonal_m", body.diagonal_m},
                      {"cluster", score.cluster},
                      {"truth", TruthToJson(body, estimate_from_truth)},
                      {"estimated", PositionsToJson(score.errors, estimate_from_truth)},
                      {"predicted", PositionsToJson(score.predicted, estimate_from_truth)}});
  }
  return bodies;
}

}  // namespace

std::string TruthFile(const std::string& job, const TruthRecord& truth) {
  const RigidTransform estimate_from_truth = truth.truth_from_estimate.Inverse();
  return DumpJson(
      {{"schema_version", kSchemaVersion},
       {"kind", "truth"},
       {"job", job},
       {"camera", truth.camera ? CameraToJson(*truth.camera, estimate_from_truth) : Json::array()},
       {"bodies",
        truth.objects && truth.bodies ? BodiesToJson(truth, estimate_from_truth) : Json::array()}});
}

}  // namespace cvo
