// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/figures/figure.h"
#include "reports/results/truth.h"

namespace cvo::reports {

// Values over time, in ascending order of time.
struct TimedValues {
  std::vector<double> time;
  std::vector<double> values;
};

struct PlottedTrack {
  std::string name;
  std::string legend;  // the name with the main numbers of the track
  std::vector<double> time;
  std::vector<Position> position_m;
  // Errors with respect to the reference; empty if there is none.
  TimedValues position_error_m;
  TimedValues rotation_error_deg;
};

// A body. It is drawn on the map only.
struct PlottedBody {
  std::string name;
  std::vector<double> truth_time;
  std::vector<Position> truth_m;
  std::vector<double> time;
  std::vector<Position> position_m;
};

// The direction of the vertical axis: cameras have y down, most other systems z up.
enum class Vertical { kYDown, kZUp };

struct TrajectoryPlot {
  std::string title;  // first sentence: what is shown; the rest: how it is aligned and paired
  std::string caption;
  std::string time_title;   // "time (s)"
  std::string error_title;  // "position error", or "distance" if the reference is no ground truth
  std::string rotation_title;
  Vertical vertical = Vertical::kYDown;
  std::vector<PlottedTrack> truth;  // at most one
  std::vector<PlottedTrack> tracks;
  std::vector<PlottedBody> bodies;  // of the first track
};

// Draws a map from above, the coordinates over time and, if there are any, the errors over time.
Figure DrawTrajectoryPlot(const TrajectoryPlot& plot);

}  // namespace cvo::reports
