// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/system_run.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "core/interface/frame.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/datasets/plausibility.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_job.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

bool IsPart(const Sequence& sequence) {
  return sequence.images.size() < static_cast<std::size_t>(sequence.total_frames);
}

OptionalPoses ReadKittiAtFrames(const std::filesystem::path& path, const Sequence& sequence) {
  const std::vector<RigidTransform> poses = ReadKittiPoses(path);
  const std::size_t frames = sequence.images.size();
  const auto total = static_cast<std::size_t>(sequence.total_frames);
  if (poses.size() != total && poses.size() != frames) {
    ThrowError(StrCat(path.string(), ":", poses.size()),
               StrCat("the last of ", poses.size(), " poses"),
               StrCat(total, ", one per frame of ", sequence.name,
                      IsPart(sequence) ? StrCat(", or ", frames, ", one per frame read") : ""));
  }
  const auto skip = poses.size() == total ? sequence.first_frame : 0;
  return {poses.begin() + skip, poses.begin() + skip + static_cast<std::ptrdiff_t>(frames)};
}

// Reads the poses of a TUM file at the frames of the sequence, matched by timestamp to within 20
// ms; empty for frames without a pose. Ignores poses before and after the part of a folder that is
// read. Throws Error with file and line for any other pose that belongs to no frame.
OptionalPoses ReadTumAtFrames(const std::filesystem::path& path, const Sequence& sequence) {
  const TrajectoryFile file = ReadTrajectory(path);
  if (!file.left_out.empty()) {
    ThrowError(StrCat(path.string(), ":", file.left_out.front()), "NaN", "numbers");
  }
  const Trajectory& trajectory = file.poses;
  Trajectory frames;
  for (const std::int64_t time_ns : sequence.timestamps_ns) frames.push_back({time_ns, {}});
  const TimeAssociation association = AssociateByTime(frames, trajectory);
  std::vector<bool> matched(trajectory.size());
  for (const auto& [frame, pose] : association.pairs) matched[pose] = true;
  const std::int64_t first_ns = sequence.timestamps_ns.front();
  const std::int64_t last_ns = sequence.timestamps_ns.back();
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const std::int64_t time_ns = trajectory[i].timestamp_ns;
    const bool outside = time_ns < first_ns || time_ns > last_ns;
    if (matched[i] || (outside && IsPart(sequence))) continue;
    ThrowError(StrCat(path.string(), ":", file.lines[i]), "time " + FormatSecondsNs(time_ns),
               StrCat("that of a frame, one pose for each, to within ",
                      FormatSecondsNs(kDefaultAssociation_ns), " s; frames are from ",
                      FormatSecondsNs(first_ns), " to ", FormatSecondsNs(last_ns), " s"));
  }
  return PosesAtFrames(association, frames.size(), trajectory);
}

// Reads camera poses from such a TUM file, or from a KITTI file with one line per frame of the
// folder or of the part that is read. Also throws Error if fewer than two frames have a pose.
OptionalPoses ReadCameraAtFrames(const std::filesystem::path& path, const Sequence& sequence) {
  OptionalPoses poses =
      IsKittiPoseFile(path) ? ReadKittiAtFrames(path, sequence) : ReadTumAtFrames(path, sequence);
  const auto found =
      std::count_if(poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); });
  if (found < 2) {
    ThrowError(path.string(), StrCat(found, " poses of the frames that are read"), "2 or more");
  }
  return poses;
}

// Object poses by id and by frame, counted from the first one read.
using ObjectPoses = std::map<std::int64_t, std::map<int, RigidTransform>>;

struct Objects {
  ObjectPoses world_from_object;
  std::map<std::int64_t, std::string> categories;
};

RigidTransform CameraFromObject(const ObjectBox::Box3d& box, double left_offset_m) {
  return {ExpSo3(box.heading_rad * Eigen::Vector3d::UnitY()),
          box.bottom_in_camera + Eigen::Vector3d(left_offset_m, -0.5 * box.height_m, 0.0)};
}

void CheckRow(const ObjectBox& row, const std::string& where) {
  if (row.track < 0) ThrowError(where, StrCat("track ", row.track), "0 or more");
  if (!row.box3d) ThrowError(where, "a row without a 3D box", "height, width and length above 0");
}

Objects ReadRows(const SystemFiles& files, const Sequence& sequence, SystemEstimate& system) {
  const fs::path& path = files.objects;
  const int first_frame = files.first_frame.value_or(sequence.first_frame);
  // Row i is on line i + 1, as such a file has neither comments nor blank lines.
  const std::vector<ObjectBox> rows = ReadDetections(path, sequence.total_frames);
  if (rows.empty()) {
    ThrowError(path.string() + ":1", "no row",
               "KITTI tracking rows (of a system that found nothing: one of type DontCare)");
  }
  Objects objects;
  std::map<std::pair<int, int>, std::string> seen;  // by frame and track
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ObjectBox& row = rows[i];
    if (row.type == "DontCare") continue;
    const std::string where = StrCat(path.string(), ":", i + 1);
    CheckRow(row, where);
    const auto [other, added] = seen.try_emplace({row.frame, row.track}, where);
    if (!added) {
      ThrowError(where,
                 StrCat("track ", row.track, " in frame ", row.frame, " as in ", other->second),
                 "one row");
    }
    const int frame = row.frame - first_frame;
    if (frame < 0 || static_cast<std::size_t>(frame) >= sequence.images.size()) continue;
    ++system.object_frames;
    const auto& camera = system.objects.world_from_camera[static_cast<std::size_t>(frame)];
    if (!camera) {
      ++system.object_frames_left_out;
      continue;
    }
    objects.categories.try_emplace(row.track, row.type);
    objects.world_from_object[row.track].emplace(
        frame, *camera * CameraFromObject(*row.box3d, sequence.left_offset_m));
  }
  return objects;
}

Objects ReadFolder(const fs::path& folder, const Sequence& sequence, SystemEstimate& system) {
  std::map<std::int64_t, fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".tum") continue;
    const std::string name = entry.path().stem().string();
    const auto id = ParseInteger(name);
    if (!id || *id < 0 || std::to_string(*id) != name) {
      ThrowError(entry.path().string(), "a name that is no number", "<id>.tum");
    }
    files.emplace(*id, entry.path());
  }
  if (files.empty()) ThrowError(folder.string(), "no file", "<id>.tum, one per object");
  Objects objects;
  for (const auto& [id, file] : files) {
    const OptionalPoses poses = ReadTumAtFrames(file, sequence);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (!poses[k]) continue;
      objects.world_from_object[id].emplace(static_cast<int>(k), *poses[k]);
      ++system.object_frames;
    }
  }
  return objects;
}

// Returns the velocity of the origin: the central difference if both neighbouring frames have a
// pose, else a one-sided one. Empty if neither has.
std::optional<Eigen::Vector3d> Velocity(const std::map<int, RigidTransform>& poses, int frame,
                                        const Sequence& sequence) {
  const int before = poses.contains(frame - 1) ? frame - 1 : frame;
  const int after = poses.contains(frame + 1) ? frame + 1 : frame;
  if (before == after) return std::nullopt;
  const auto time_ns = [&](int k) { return sequence.timestamps_ns[static_cast<std::size_t>(k)]; };
  const double time_s = 1e-9 * static_cast<double>(time_ns(after) - time_ns(before));
  return Eigen::Vector3d((poses.at(after).translation() - poses.at(before).translation()) / time_s);
}

std::vector<ClusterEstimate> Clusters(const Objects& objects, const Sequence& sequence) {
  std::vector<ClusterEstimate> clusters;
  for (const auto& [id, poses] : objects.world_from_object) {
    const auto category = objects.categories.find(id);
    ClusterEstimate cluster{id, category == objects.categories.end() ? "" : category->second, {}};
    for (const auto& [k, world_from_object] : poses) {
      ClusterFrame frame;
      frame.frame = k;
      frame.world_from_object = world_from_object;
      frame.velocity_m_s = Velocity(poses, k, sequence);
      frame.observed_landmarks.reset();
      cluster.frames.push_back(frame);
    }
    clusters.push_back(std::move(cluster));
  }
  return clusters;
}

}  // namespace

SystemEstimate ReadSystem(const Sequence& sequence, const SystemFiles& files) {
  SystemEstimate system;
  ObjectEstimate& estimate = system.objects;
  estimate.match_by = MatchBy::kNearness;
  estimate.differentiated = true;
  estimate.world_from_camera = ReadCameraAtFrames(files.camera, sequence);
  estimate.landmarks.resize(estimate.world_from_camera.size());
  system.frames_without_camera = static_cast<int>(std::count(
      estimate.world_from_camera.begin(), estimate.world_from_camera.end(), std::nullopt));
  if (files.objects.empty()) return system;
  const Objects objects = fs::is_directory(files.objects)
                              ? ReadFolder(files.objects, sequence, system)
                              : ReadRows(files, sequence, system);
  estimate.clusters = Clusters(objects, sequence);
  return system;
}

namespace {

Json FramesToJson(const Sequence& sequence, const OptionalPoses& poses) {
  Json frames = Json::array();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto& pose = poses[k];
    frames.push_back({{"frame", sequence.first_frame + static_cast<int>(k)},
                      {"timestamp_ns", sequence.timestamps_ns[k]},
                      {"status", ToString(pose ? FrameStatus::kTracked : FrameStatus::kSkipped)},
                      {"refined", pose ? Json(PoseOf(*pose)) : Json(nullptr)}});
  }
  return frames;
}

Json ClustersToJson(int first_frame, const std::vector<ClusterEstimate>& estimates) {
  Json clusters = Json::array();
  for (const ClusterEstimate& cluster : estimates) {
    clusters.push_back({{"id", cluster.id},
                        {"category", cluster.category},
                        {"frames", cluster.frames.size()},
                        {"tracked", cluster.frames.size()},
                        {"first_frame", first_frame + cluster.frames.front().frame},
                        {"last_frame", first_frame + cluster.frames.back().frame}});
  }
  return clusters;
}

// Hashes a file, or the names and bytes of the trajectories in a folder.
std::string HashObjects(const fs::path& objects) {
  if (objects.empty()) return "";
  if (!fs::is_directory(objects)) return Sha256Hex(ReadFileBytes(objects));
  Json hashes = Json::object();  // sorted by name
  for (const fs::path& file : fs::directory_iterator(objects)) {
    if (file.extension() == ".tum")
      hashes[file.filename().string()] = Sha256Hex(ReadFileBytes(file));
  }
  return Sha256Hex(DumpJson(hashes));
}

// Hashes of the bytes of the files that another system wrote; without objects, that is empty.
Json HashesOf(const SystemFiles& files) {
  return {{"camera", Sha256Hex(ReadFileBytes(files.camera))},
          {"objects", HashObjects(files.objects)}};
}

// A program is identified before it runs, files that exist by their bytes. The whole build is part
// of the identity: the readers of the ground truth and the geometry needed for scoring are among
// the estimator's sources.
std::string IdentityOf(const SystemRequest& request, const Json& made) {
  return reports::JobIdentity({ThisBuild().identity, reports::SystemVariant(request.files.name),
                               made, request.content, "", GivenToJson({}, {}), request.seed});
}

// Returns the content of result.json, of kind "run" like that of an own run. Poses are the system's
// own, null in frames without one.
std::string ResultOf(const SystemRequest& request, const SystemOutcome& outcome) {
  const Json hashes = HashesOf(request.files);
  reports::RunSummary summary;
  summary.job = IdentityOf(request, request.program.is_null() ? hashes : request.program);
  summary.status = ToString(RunStatus::kOk);
  summary.variant = reports::SystemVariant(request.files.name);
  summary.system = Json{{"name", request.files.name},
                        {"camera", hashes["camera"]},
                        {"objects", hashes["objects"] == "" ? Json(nullptr) : hashes["objects"]},
                        {"object_frames", outcome.object_frames},
                        {"object_frames_left_out", outcome.object_frames_left_out}};
  if (!request.program.is_null()) (*summary.system)["program"] = request.program;
  summary.seed = request.seed;
  summary.sequence =
      SequenceOf(request.sequence, request.content, FindImplausible(request.sequence));
  summary.sequence.images = request.images;
  summary.sequence.camera.right_shift_px = request.right_shift_px;
  summary.given = GivenToJson({}, {});
  summary.build = ThisBuild();
  summary.metrics = outcome.metrics;
  if (!outcome.bodies.empty()) {
    summary.bodies = reports::RunBodies{{outcome.bodies.begin(), outcome.bodies.end()}, {}};
  }
  const ObjectEstimate& estimate = outcome.objects;
  const int missing = outcome.frames_without_camera;
  const auto frames = static_cast<int>(estimate.world_from_camera.size());
  return DumpJson(ResultJson(
      summary, {{"clusters", ClustersToJson(request.sequence.first_frame, estimate.clusters)},
                {"frame_counts",
                 {{ToString(FrameStatus::kTracked), frames - missing},
                  {ToString(FrameStatus::kSkipped), missing}}},
                {"pose_layout", {"tx_m", "ty_m", "tz_m", "qx", "qy", "qz", "qw"}},
                {"frames", FramesToJson(request.sequence, estimate.world_from_camera)}}));
}

}  // namespace

std::string IdentifySystem(const SystemRequest& request) {
  return IdentityOf(request, request.program.is_null() ? HashesOf(request.files) : request.program);
}

SystemOutcome ScoreSystem(const SystemRequest& request) {
  SystemOutcome outcome{ReadSystem(request.sequence, request.files)};
  const std::unique_ptr<BodyTruthReader> reader =
      request.files.objects.empty() ? nullptr : ReadBodyTruth(request.sequence);
  const ObjectTruth* truth = reader ? &reader->objects() : nullptr;
  PoseScores scores = ScorePoses(request.sequence, truth, outcome.objects);
  outcome.metrics = std::move(scores.metrics);
  outcome.bodies = std::move(scores.bodies);
  StatePoses(reports::PoseTime::kRefined, request.right_shift_px, outcome.metrics);
  outcome.result = ResultOf(request, outcome);
  return outcome;
}

}  // namespace cvo
