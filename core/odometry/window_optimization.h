// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/estimation/row_evidence.h"
#include "core/estimation/window.h"
#include "core/estimation/window_policies.h"
#include "core/estimation/window_problem.h"
#include "core/solvers/solver_policy.h"

namespace cvo {

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

// Bundle adjustment of the window (static energy of section 3.3 of the paper). `Gauge` decides
// which frames are held fixed, `Calibration` whether camera.right_field_px is.
template <GaugePolicy Gauge, CalibrationPolicy Calibration, OutlierPolicy Outliers,
          SolverPolicy Solver>
WindowReport OptimizeWindow(const FeatureNoise& noise, const SolverOptions& options,
                            const RowField& rows, Window& window) {
  WindowProblem problem = MakeFrames(window);
  const std::vector<const WindowFrame*> frames = window.Frames();
  for (std::size_t i = 0; i < problem.frames.size(); ++i) {
    problem.is_fixed[i] = frames[i]->is_given || Gauge::Fixes(static_cast<int>(i), problem.prior);
  }
  problem.is_right_field_fixed = Calibration::kFixesRightField;
  if (!Calibration::kFixesRightField) {
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

}  // namespace cvo
