// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/cluster_update.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/camera_solver.h"
#include "core/estimation/double_track.h"
#include "core/labelling/frame_points.h"

namespace cvo {

ShownBodies MaskDetections::Show(StereoFrame& frame) {
  for (StereoFeature& feature : frame.features) {
    if (IsDetected(frame.detections, feature)) feature.disagreement_px = kNoDisparity_px;
  }
  return {};
}

namespace {

// Minimum observed landmarks for a cluster with a pose to be reported as tracked, not predicted
// (METHOD.md 8.1).
constexpr int kMinObserved = 3;

// Writes the solution back to the window: camera, frames, and the positions of `landmarks`, from
// which the problem was made. Removes observations whose squared whitened error exceeds `gate`,
// then landmarks without observations. Returns the RMS whitened error of the remaining
// observations.
double ApplySolution(double gate, const WindowProblem& problem, const std::vector<int>& landmarks,
                     Window& window) {
  window.camera = problem.camera;
  std::size_t i = 0;
  for (std::vector<WindowFrame>* track : {&window.spatial, &window.temporal}) {
    for (WindowFrame& frame : *track) frame.world_from_camera = problem.world_from_camera[i++];
  }
  std::vector<RigidTransform> camera_from_world;
  for (const RigidTransform& pose : problem.world_from_camera) {
    camera_from_world.push_back(pose.Inverse());
  }
  double sum = 0.0;
  int count = 0;
  std::size_t next = 0;  // factors are in the order of the landmarks and their observations
  for (std::size_t k = 0; k < landmarks.size(); ++k) {
    Landmark& landmark = window.landmarks[landmarks[k]];
    landmark.p_in_object = problem.points[k];
    std::vector<Observation> kept;
    for (const Observation& observation : landmark.observations) {
      const ReprojectionFactor& factor = problem.factors[next++];
      const auto error = WhitenedError(problem.camera,
                                       {landmark.p_in_object, factor.z_px, factor.sqrt_information},
                                       camera_from_world[factor.pose]);
      if (!error || error->squaredNorm() > gate) continue;
      kept.push_back(observation);
      sum += error->squaredNorm();
      ++count;
    }
    landmark.observations = std::move(kept);
  }
  window.RemoveUnobserved();
  return count > 0 ? std::sqrt(sum / count) : 0.0;
}

// How often a disparity is measured with the error of the same landmark: the mean over observations
// of the number of observations of their landmark.
double MeanRepeats(const std::vector<Landmark>& landmarks, const std::vector<int>& used) {
  double observations = 0.0;
  double squares = 0.0;
  for (const int i : used) {
    const double count = static_cast<double>(landmarks[i].observations.size());
    observations += count;
    squares += count * count;
  }
  return squares / observations;
}

}  // namespace

void OptimizeWindow(const Options& options, const EnergySteps& steps, const RowField& rows,
                    Window& window, FrameReport& report) {
  const NoiseOptions& noise = options.noise;
  WindowProblem problem = MakeFrames(window);
  const std::vector<const WindowFrame*> frames = window.Frames();
  for (std::size_t i = 0; i < problem.frames.size(); ++i) {
    problem.is_fixed[i] = i == 0 || frames[i]->is_given;
  }
  problem.is_right_field_fixed = TrustsCalibration(noise);
  if (!problem.is_right_field_fixed) {
    AppendRowEvidence(rows, window.camera, noise.row_field_px, problem.prior);
  }
  const std::vector<int> landmarks = SelectLandmarks(window, SolverOptions::kMaxPoints);
  for (const int i : landmarks) {
    AddLandmark(window.landmarks[i], options.NoiseOfFeatures(), problem);
  }
  report.window_landmarks = static_cast<int>(landmarks.size());
  if (!landmarks.empty()) {
    const SolverSummary summary = steps.solve_window(noise, options.solver, problem);
    report.window_iterations = summary.iterations;
    report.window_endings.Count(summary.ending);
    report.calibration.information =
        summary.shared_information / MeanRepeats(window.landmarks, landmarks);
    report.mean_error_px = ApplySolution(steps.gate(noise), problem, landmarks, window);
  }
  report.calibration.right_field_px = window.camera.right_field_px;
}

namespace {

ClusterReport DescribeCluster(FrameId newest, const Cluster& cluster) {
  ClusterReport report;
  report.id = cluster.id;
  report.category = cluster.category;
  report.world_from_object = cluster.Latest().world_from_object;
  report.velocity_m_s = cluster.Latest().velocity_m_s;
  report.center_in_object = cluster.center_in_object;
  report.half_size_m = cluster.half_size_m;
  report.observed_landmarks = static_cast<int>(
      std::count_if(cluster.landmarks.begin(), cluster.landmarks.end(),
                    [&](const Landmark& landmark) { return landmark.last_seen == newest; }));
  report.detection = cluster.last_detected == newest ? cluster.detection : -1;
  const bool is_tracked =
      cluster.Latest().frame == newest && report.observed_landmarks >= kMinObserved;
  report.status = is_tracked ? ClusterStatus::kTracked : ClusterStatus::kPredicted;
  return report;
}

// Appends the report's pose, and overwrites the poses of all frames in which the cluster has a
// state.
void RecordTrajectory(const Cluster& cluster, const ClusterReport& report, FrameId newest,
                      std::int64_t timestamp_ns, ClusterTrajectory& trajectory) {
  trajectory.id = cluster.id;
  trajectory.category = cluster.category;
  trajectory.poses.push_back({report, newest.value, timestamp_ns});
  for (const ClusterState& state : cluster.states) {
    const auto it = FirstPoseFrom(state.frame.value, trajectory);
    if (it == trajectory.poses.end() || it->frame != state.frame.value) continue;
    it->world_from_object = state.world_from_object;
    it->velocity_m_s = state.velocity_m_s;
  }
}

}  // namespace

void AddStates(const FrameView& view, FrameId newest, const std::vector<ClusterTrack>& tracks,
               ClusterMap& map) {
  for (std::size_t q = 0; q < tracks.size(); ++q) {
    Cluster& cluster = map.live[q];
    const ClusterTrack& track = tracks[q];
    cluster.detection = track.detection;
    if (track.detection >= 0) {
      ++cluster.detections;
      cluster.last_detected = newest;
      cluster.score = view.shown.detections[track.detection].score;
    }
    if (!track.is_tracked) continue;
    cluster.states.push_back(
        {newest, view.frame.timestamp_ns, track.world_from_object, track.predicted.velocity_m_s});
    cluster.last_observed = newest;
    ++cluster.frames;
  }
}

std::vector<ClusterReport> DescribeClusters(FrameId newest, const ClusterPredictor& predict,
                                            const ClusterMap& map) {
  std::vector<ClusterReport> reports;
  for (const Cluster& cluster : map.live) {
    ClusterReport report = DescribeCluster(newest, cluster);
    if (cluster.Latest().frame < newest) {
      const PredictedCluster predicted = predict(cluster);
      report.world_from_object = predicted.world_from_object;
      report.velocity_m_s = predicted.velocity_m_s;
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

std::vector<ClusterReport> RecordClusters(const ClusterOptions& options, FrameId newest,
                                          std::int64_t timestamp_ns,
                                          std::vector<ClusterReport> reports, ClusterMap& map) {
  std::vector<ClusterReport> confirmed;
  for (std::size_t q = 0; q < map.live.size(); ++q) {
    const Cluster& cluster = map.live[q];
    RecordTrajectory(cluster, reports[q], newest, timestamp_ns, map.trajectories[cluster.id]);
    if (IsConfirmed(cluster, options)) confirmed.push_back(std::move(reports[q]));
  }
  return confirmed;
}

}  // namespace cvo
