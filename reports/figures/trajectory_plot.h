// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/figures/figure.h"
#include "reports/results/truth.h"

namespace cvo::reports {

// Numbers over time, times ascending.
struct TimedValues {
  std::vector<double> time;
  std::vector<double> values;
};

struct PlottedTrack {
  std::string name;
  std::string legend;  // the name and its main numbers
  std::vector<double> time;
  std::vector<Position> position_m;
  // Against the reference; empty where there is none.
  TimedValues position_error_m;
  TimedValues rotation_error_deg;
};

// A body, drawn on the map alone.
struct PlottedBody {
  std::string name;
  std::vector<double> truth_time;
  std::vector<Position> truth_m;
  std::vector<double> time;
  std::vector<Position> position_m;
};

// What the vertical is: cameras have y down, most other systems z up.
enum class Vertical { kYDown, kZUp };

struct TrajectoryPlot {
  std::string title;  // first sentence: what; the rest: how it is aligned and paired
  std::string caption;
  std::string time_title;   // "time (s)"
  std::string error_title;  // "position error"; "distance" from what is no truth
  std::string rotation_title;
  Vertical vertical = Vertical::kYDown;
  std::vector<PlottedTrack> truth;  // at most one
  std::vector<PlottedTrack> tracks;
  std::vector<PlottedBody> bodies;  // of the first track
};

// A map from above, coordinates over time and, where there are any, errors over time.
Figure DrawTrajectoryPlot(const TrajectoryPlot& plot);

}  // namespace cvo::reports
