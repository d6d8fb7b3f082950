// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/system_result.h"

#include <algorithm>
#include <optional>

#include "core/interface/frame.h"
#include "experiments/datasets/sequence.h"
#include "experiments/record/job_identity.h"
#include "experiments/record/result_file.h"

namespace cvo {
namespace {

FrameStatus StatusOf(const std::optional<RigidTransform>& pose) {
  return pose ? FrameStatus::kTracked : FrameStatus::kSkipped;
}

Json FramesToJson(const SystemRecord& record) {
  Json frames = Json::array();
  for (std::size_t k = 0; k < record.estimate.world_from_camera.size(); ++k) {
    const auto& pose = record.estimate.world_from_camera[k];
    frames.push_back({{"frame", record.sequence.first_frame + static_cast<int>(k)},
                      {"timestamp_ns", record.sequence.timestamps_ns[k]},
                      {"status", ToString(StatusOf(pose))},
                      {"refined", pose ? PoseToJson(*pose) : Json(nullptr)}});
  }
  return frames;
}

Json CountsToJson(const OptionalPoses& poses) {
  const auto missing = std::count(poses.begin(), poses.end(), std::nullopt);
  return {{ToString(FrameStatus::kTracked), static_cast<std::int64_t>(poses.size()) - missing},
          {ToString(FrameStatus::kSkipped), missing}};
}

Json ClustersToJson(const SystemRecord& record) {
  Json clusters = Json::array();
  for (const ClusterEstimate& cluster : record.estimate.clusters) {
    const int first = record.sequence.first_frame;
    clusters.push_back({{"id", cluster.id},
                        {"category", cluster.category},
                        {"frames", cluster.frames.size()},
                        {"tracked", cluster.frames.size()},
                        {"first_frame", first + cluster.frames.front().frame},
                        {"last_frame", first + cluster.frames.back().frame}});
  }
  return clusters;
}

Json FilesToJson(const SystemRecord& record) {
  Json files = {{"name", record.system}, {"camera", record.hashes.camera}};
  files["objects"] = record.hashes.objects.empty() ? Json(nullptr) : Json(record.hashes.objects);
  files["object_frames"] = record.object_frames;
  files["object_frames_left_out"] = record.object_frames_left_out;
  return files;
}

}  // namespace

std::string SystemJob(const BuildIdentity& build, const std::string& system,
                      const SystemHashes& hashes, const std::string& content, std::uint64_t seed) {
  return JobIdentity({build.identity,
                      reports::SystemVariant(system),
                      {{"camera", hashes.camera}, {"objects", hashes.objects}},
                      content,
                      "",
                      GivenToJson({}, {}),
                      seed});
}

std::string SystemResultFile(const SystemRecord& record) {
  reports::RunSummary summary;
  summary.job = SystemJob(record.build, record.system, record.hashes, record.content, record.seed);
  summary.status = ToString(RunStatus::kOk);
  summary.variant = reports::SystemVariant(record.system);
  summary.system = FilesToJson(record);
  summary.seed = record.seed;
  summary.sequence =
      SequenceOf(record.sequence, record.content, FindImplausible(record.sequence, record.truth));
  summary.sequence.camera.right_shift_px = record.right_shift_px;
  summary.given = GivenToJson({}, {});
  summary.build = record.build;
  summary.metrics = record.metrics;
  summary.bodies = record.bodies;
  return DumpJson(
      ResultJson(summary, {{"clusters", ClustersToJson(record)},
                           {"frame_counts", CountsToJson(record.estimate.world_from_camera)},
                           {"pose_layout", {"tx_m", "ty_m", "tz_m", "qx", "qy", "qz", "qw"}},
                           {"frames", FramesToJson(record)}}));
}

}  // namespace cvo
