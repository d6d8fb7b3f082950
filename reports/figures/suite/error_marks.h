// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "reports/figures/palette.h"
#include "reports/figures/suite/suite_figures.h"

namespace cvo::reports {

// Unit and axis scale for the errors of a scene.
struct ErrorScale {
  double from_m = 100.0;
  const char* unit = "cm";
  bool log = false;

  // The number to plot, at least 0.01 on a logarithmic axis: a body that is estimated only once has
  // an error of 0, which a logarithm cannot show.
  double Shown(double error_m) const;
};

// A trace of errors over frames, broken where frames are missing.
Json ErrorLine(const std::vector<BodyPosition>& positions, const ErrorScale& scale);

// Marks at frames, at the height of the error of the body in that frame or in the nearest one that
// has one.
class FrameMarks {
 public:
  FrameMarks(const char* symbol, const char* what) : symbol_(symbol), what_(what) {}

  void Add(const BodyDetail& body, int frame, const DrawnRun& run, const ErrorScale& scale,
           const Style& style);
  bool empty() const { return x_.empty(); }
  Json Trace() const;

 private:
  const char* symbol_;
  const char* what_;
  Json x_ = Json::array();
  Json y_ = Json::array();
  Json texts_ = Json::array();
  Json colours_ = Json::array();
};

}  // namespace cvo::reports
