// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/pictures/plot_tracks.h"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "core/base/error.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "core/record/run_summary.h"
#include "experiments/datasets/sequence_parts.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kStep_ns = 1'000'000'000;  // between poses without timestamps

bool HasCommas(const fs::path& path) {
  const TextFile file(path);
  for (std::size_t i = 0; i < file.size(); ++i) {
    if (!file.line(i).empty() && !file.line(i).starts_with('#')) {
      return file.line(i).find(',') != std::string::npos;
    }
  }
  return false;
}

Trajectory ReadKittiTrajectory(const fs::path& path) {
  Trajectory trajectory;
  for (const RigidTransform& pose : ReadKittiPoses(path)) {
    trajectory.push_back({static_cast<std::int64_t>(trajectory.size()) * kStep_ns, pose});
  }
  return trajectory;
}

RigidTransform TransformOf(const reports::Pose& pose) {
  return {Eigen::Quaterniond(pose[6], pose[3], pose[4], pose[5]),
          Eigen::Vector3d(pose[0], pose[1], pose[2])};
}

PlotInput ReadRunInput(const std::string& path) {
  const fs::path result = fs::path(path) / "result.json";
  if (!fs::exists(result)) {
    ThrowError(path, "a folder without result.json or plan.json",
               "the output folder of a run or of a suite, or a trajectory file");
  }
  const reports::RunSummary run = reports::ReadRun(result, {});
  reports::RunDetail detail = reports::ReadRunDetail(path);
  PlotInput input{path, run.variant, run.sequence.name, {}, true, true, {}, {}};
  for (const reports::CameraFrame& frame : detail.camera) {
    if (frame.truth) input.truth.push_back({frame.timestamp_ns, TransformOf(*frame.truth)});
    if (frame.status == "skipped") continue;
    input.poses.push_back({frame.timestamp_ns, TransformOf(frame.world_from_camera)});
  }
  input.bodies = std::move(detail.bodies);
  return input;
}

}  // namespace

double Seconds(std::int64_t time_ns) { return 1e-9 * static_cast<double>(time_ns); }

PlotInput ReadPlotInput(const std::string& path) {
  PlotInput input;
  if (fs::is_directory(path)) {
    input = ReadRunInput(path);
  } else {
    input.path = path;
    input.name = fs::path(path).stem().string();
    if (HasCommas(path)) {
      input.poses = ReadEurocPoses(path);
    } else {
      input.timed = DetectPoseFormat(path) == "tum";
      input.camera_axes = !input.timed;
      input.poses = input.timed ? ReadTumTrajectory(path) : ReadKittiTrajectory(path);
    }
  }
  if (input.poses.empty()) ThrowError(path, "no pose", "a trajectory");
  return input;
}

void MakeComparable(std::vector<PlotInput>& inputs) {
  std::vector<std::string> names;
  std::vector<std::string> paths;
  for (const PlotInput& input : inputs) {
    names.push_back(input.name);
    paths.push_back(input.path);
  }
  names = UniqueNames(names, paths);
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i].name = names[i];
  const auto counted = std::find_if(inputs.begin(), inputs.end(),
                                    [](const PlotInput& input) { return !input.timed; });
  if (counted == inputs.end()) return;
  for (PlotInput& input : inputs) {
    if (input.poses.size() != counted->poses.size()) {
      ThrowError(input.path, StrCat(input.poses.size(), " poses"),
                 StrCat(counted->poses.size(), ", as many as ", counted->path,
                        " (KITTI files have no times to match by)"));
    }
    if (input.timed && input.truth.size() != input.poses.size()) input.truth.clear();
    input.timed = false;
    for (std::size_t i = 0; i < input.poses.size(); ++i) {
      input.poses[i].timestamp_ns = static_cast<std::int64_t>(i) * kStep_ns;
      if (!input.truth.empty()) input.truth[i].timestamp_ns = input.poses[i].timestamp_ns;
    }
  }
}

std::optional<PlotReference> ReferenceAmong(const std::vector<PlotInput>& inputs) {
  for (const PlotInput& input : inputs) {
    if (input.truth.empty()) continue;
    return PlotReference{"truth of " + input.sequence, input.truth, true, true};
  }
  if (inputs.size() < 2) return std::nullopt;
  return PlotReference{inputs.front().name, inputs.front().poses, false, false};
}

PlotTrack MatchTrack(const PlotReference& reference, const PlotInput& input,
                     const PlotMatching& matching) {
  const TimeAssociation association =
      AssociateByTime(reference.poses, input.poses, matching.tolerance_ns);
  if (association.pairs.size() < 2) {
    ThrowError(input.path,
               StrCat(association.pairs.size(), " poses that match one of ", reference.name),
               StrCat("2 or more within ", Seconds(matching.tolerance_ns), " s"));
  }
  PlotTrack track{.name = input.name, .matched = association.pairs.size()};
  CommonPoses poses;
  for (const auto& [i, k] : association.pairs) {
    poses.frames.push_back(static_cast<int>(i));
    poses.truth.push_back(reference.poses[i].world_from_camera);
    poses.estimate.push_back(input.poses[k].world_from_camera);
    track.times_s.push_back(Seconds(input.poses[k].timestamp_ns));
  }
  const Eigen::Vector3d up =
      matching.z_up ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(-Eigen::Vector3d::UnitY());
  const Similarity moved = AlignTrajectory(poses, matching.alignment, up);
  track.scale = moved.scale;
  for (const TimedPose& pose : input.poses) {
    track.poses.push_back({pose.timestamp_ns, moved * pose.world_from_camera});
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    track.errors_m.push_back(
        (moved * poses.estimate[i].translation() - poses.truth[i].translation()).norm());
  }
  for (const double error_rad : OrientationErrors(poses, matching.alignment, moved)) {
    track.errors_deg.push_back(error_rad * 180.0 / std::numbers::pi);
  }
  return track;
}

}  // namespace cvo
