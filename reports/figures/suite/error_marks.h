// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "reports/figures/palette.h"
#include "reports/figures/suite/suite_figures.h"

namespace cvo::reports {

// How the errors of a scene are shown.
struct ErrorScale {
  double from_m = 100.0;
  const char* unit = "cm";
  bool log = false;

  // A body estimated once has no error at all, which a logarithm cannot show.
  double Shown(double error_m) const;
};

// A trace of errors that is broken where frames are missing.
Json ErrorLine(const std::vector<BodyPosition>& positions, const ErrorScale& scale);

// Marks at frames, at the height of the error there or of the nearest one.
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
