// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>

#include "core/bodies/body_boxes.h"
#include "core/estimation/double_track.h"
#include "core/estimation/window.h"
#include "core/estimation/window_problem.h"
#include "core/interface/frame.h"
#include "core/labelling/cluster_labels.h"
#include "core/solvers/schur_solver.h"

namespace cvo {

// Selects the detections, and the given knowledge of bodies, that the estimator is shown.
template <typename Policy>
concept DetectionPolicy = requires(const StereoFrame& frame) {
  { Policy::Show(frame) } -> std::same_as<ShownBodies>;
};

// Policy: all those of the frame.
struct UseDetections {
  static ShownBodies Show(const StereoFrame& frame) {
    return {frame.detections, frame.given.feature_body, frame.given.detection_body};
  }
  static ShownBodies Show(StereoFrame&&) = delete;  // the views would outlive the frame
};
// Policy: none. No cluster is ever found, and the world is assumed to be static.
struct IgnoreDetections {
  static ShownBodies Show(const StereoFrame&) { return {}; }
};

struct WindowReport {
  int landmarks = 0;
  int iterations = 0;
  SolverEndings endings;
  double mean_error_px = 0.0;                           // RMS whitened error (ApplySolution)
  Matrix6d right_field_information = Matrix6d::Zero();  // 1/px^2
};

// Writes the solution back to the window: camera, frames, and the positions of `landmarks`, from
// which the problem was made. Removes observations whose squared whitened error exceeds `gate`,
// then landmarks without observations. Returns the RMS whitened error of the remaining
// observations.
double ApplySolution(double gate, const WindowProblem& problem, const std::vector<int>& landmarks,
                     Window& window);

// Bundle adjustment of the window (static energy of section 3.3 of the paper). The oldest frame is
// held fixed (METHOD.md 7.4).
template <OutlierPolicy Outliers, SolverPolicy Solver>
WindowReport OptimizeWindow(const FeatureNoise& noise, const SolverOptions& options,
                            const RowField& rows, Window& window) {
  WindowProblem problem = MakeFrames(window);
  const std::vector<const WindowFrame*> frames = window.Frames();
  for (std::size_t i = 0; i < problem.frames.size(); ++i) {
    problem.is_fixed[i] = i == 0 || frames[i]->is_given;
  }
  problem.is_right_field_fixed = TrustsCalibration(noise.options);
  if (!problem.is_right_field_fixed) {
    AppendRowEvidence(rows, window.camera, noise.options.row_field_px, problem.prior);
  }
  const std::vector<int> landmarks = SelectLandmarks(window, options.max_points);
  for (const int i : landmarks) {
    AddLandmark(window.landmarks[i], noise, problem);
  }
  WindowReport report;
  report.landmarks = static_cast<int>(landmarks.size());
  if (landmarks.empty()) return report;
  const SolverSummary summary = Solver::Solve(noise.options, options, problem);
  report.iterations = summary.iterations;
  report.endings.Count(summary.ending);
  report.right_field_information = summary.shared_information;
  report.mean_error_px = ApplySolution(Outliers::Gate(noise.options), problem, landmarks, window);
  return report;
}

// Updates the clusters from their tracks in the frame: a tracked cluster gets a state for it, and
// associated detections are counted.
void AddStates(const FrameView& view, FrameId newest, const std::vector<ClusterTrack>& tracks,
               ClusterMap& map);

// Describes every live cluster in the newest frame, after the optimisation and without boxes and
// scores. A cluster without a state in the frame is predicted.
std::vector<ClusterReport> DescribeClusters(FrameId newest, const ClusterPredictor& predict,
                                            const ClusterMap& map);

// Appends the reports of all live clusters to their trajectories, and updates the poses of T_t
// there. Returns the reports of the confirmed clusters.
std::vector<ClusterReport> RecordClusters(const ClusterOptions& options, FrameId newest,
                                          std::int64_t timestamp_ns,
                                          std::vector<ClusterReport> reports, ClusterMap& map);

std::vector<LandmarkReport> ReportLandmarks(const FrameView& view,
                                            const std::vector<FramePoint>& points,
                                            const FrameLabels& labels);

}  // namespace cvo
