// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/pictures/plot_tracks.h"

#include <algorithm>
#include <numbers>

#include "core/base/error.h"
#include "core/base/mean.h"
#include "experiments/metrics/association.h"

namespace cvo {
namespace {

using reports::PlottedTrack;

double Seconds(std::int64_t time_ns) { return 1e-9 * static_cast<double>(time_ns); }

reports::Position PositionOf(const Eigen::Vector3d& point) {
  return {point.x(), point.y(), point.z()};
}

// The upward direction of a world with this vertical axis: -y if y points down.
Eigen::Vector3d UpOf(reports::Vertical vertical) {
  if (vertical == reports::Vertical::kZUp) return Eigen::Vector3d::UnitZ();
  return -Eigen::Vector3d::UnitY();
}

PlottedTrack MovedTrack(const std::string& name, const Trajectory& poses, const Similarity& moved) {
  PlottedTrack track{name, name, {}, {}, {}, {}};
  for (const TimedPose& pose : poses) {
    track.time.push_back(Seconds(pose.timestamp_ns));
    track.position_m.push_back(PositionOf(moved * pose.world_from_camera.translation()));
  }
  return track;
}

void AddErrors(const CommonPoses& poses, const Similarity& moved, TrajectoryAlignment alignment,
               MatchedTrack& track) {
  std::vector<double>& errors_m = track.track.position_error_m.values;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    errors_m.push_back(
        (moved * poses.estimate[i].translation() - poses.truth[i].translation()).norm());
    track.mean_m += errors_m.back() / static_cast<double>(poses.size());
  }
  std::vector<double>& errors_deg = track.track.rotation_error_deg.values;
  for (const double error_rad : OrientationErrors(poses, alignment, moved)) {
    errors_deg.push_back(error_rad * 180.0 / std::numbers::pi);
  }
  track.rms_m = RootMeanSquare(errors_m).value();
  track.most_m = *std::max_element(errors_m.begin(), errors_m.end());
  track.rms_deg = RootMeanSquare(errors_deg).value();
}

}  // namespace

std::optional<PlotReference> ReferenceAmong(const std::vector<PlotInput>& inputs) {
  for (const PlotInput& input : inputs) {
    if (input.truth.empty()) continue;
    return PlotReference{"truth of " + input.sequence, input.truth, true, true};
  }
  if (inputs.size() < 2) return std::nullopt;
  return PlotReference{inputs.front().name, inputs.front().poses, false, false};
}

MatchedTrack TrackOf(const std::string& name, const Trajectory& poses) {
  return {.track = MovedTrack(name, poses, {})};
}

MatchedTrack MatchTrack(const PlotReference& reference, const PlotInput& input,
                        const PlotMatching& matching) {
  const TimeAssociation association =
      AssociateByTime(reference.poses, input.poses, matching.tolerance_ns);
  if (association.pairs.size() < 2) {
    ThrowError(input.path,
               StrCat(association.pairs.size(), " poses that match one of ", reference.name),
               StrCat("2 or more within ", Seconds(matching.tolerance_ns), " s"));
  }
  CommonPoses poses;
  std::vector<double> times;
  for (const auto& [i, k] : association.pairs) {
    poses.frames.push_back(static_cast<int>(i));
    poses.truth.push_back(reference.poses[i].world_from_camera);
    poses.estimate.push_back(input.poses[k].world_from_camera);
    times.push_back(Seconds(input.poses[k].timestamp_ns));
  }
  const Similarity moved = AlignTrajectory(poses, matching.alignment, UpOf(matching.vertical));
  MatchedTrack track{.track = MovedTrack(input.name, input.poses, moved),
                     .matched = poses.size(),
                     .scale = moved.scale};
  track.track.position_error_m.time = times;
  track.track.rotation_error_deg.time = times;
  AddErrors(poses, moved, matching.alignment, track);
  return track;
}

std::vector<reports::PlottedBody> MovingBodies(const PlotInput& run) {
  std::vector<reports::PlottedBody> bodies;
  for (const reports::BodyDetail& body : run.bodies) {
    if (!body.mover || body.visible.empty()) continue;
    reports::PlottedBody plotted{body.name, {}, {}, {}, {}};
    for (const auto& [frame, pose] : body.truth) {
      if (frame < body.visible.front() || frame > body.visible.back()) continue;
      plotted.truth_time.push_back(frame);
      plotted.truth_m.push_back({pose[0], pose[1], pose[2]});
    }
    for (const reports::BodyPosition& at : body.estimated) {
      plotted.time.push_back(at.frame);
      plotted.position_m.push_back(at.position_m);
    }
    bodies.push_back(std::move(plotted));
  }
  return bodies;
}

}  // namespace cvo
