// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite/error_marks.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "reports/figures/numbers.h"

namespace cvo::reports {
namespace {

std::optional<double> ErrorAt(const BodyDetail& body, int frame) {
  std::optional<double> error;
  int nearest = 0;
  for (const auto* positions : {&body.estimated, &body.predicted}) {
    for (const BodyPosition& position : *positions) {
      const int distance = std::abs(position.frame - frame);
      if (error && distance >= nearest) continue;
      error = position.error_m;
      nearest = distance;
    }
  }
  return error;
}

}  // namespace

double ErrorScale::Shown(double error_m) const {
  constexpr double kMinOnLogAxis = 0.01;
  return Rounded(log ? std::max(from_m * error_m, kMinOnLogAxis) : from_m * error_m, 3);
}

Json ErrorLine(const std::vector<BodyPosition>& positions, const ErrorScale& scale) {
  Json x = Json::array();
  Json y = Json::array();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (i > 0 && positions[i].frame > positions[i - 1].frame + 1) {
      x.push_back(positions[i].frame);
      y.push_back(nullptr);
    }
    x.push_back(positions[i].frame);
    y.push_back(scale.Shown(positions[i].error_m));
  }
  return {{"type", "scatter"}, {"x", x}, {"y", y}, {"showlegend", false}};
}

void FrameMarks::Add(const BodyDetail& body, int frame, const DrawnRun& run,
                     const ErrorScale& scale, const Style& style) {
  const auto error_m = ErrorAt(body, frame);
  if (!error_m) return;
  x_.push_back(frame);
  y_.push_back(scale.Shown(*error_m));
  texts_.push_back(PlotText(run.variant));
  colours_.push_back(style.colour);
}

Json FrameMarks::Trace() const {
  return {{"type", "scatter"},
          {"mode", "markers"},
          {"x", x_},
          {"y", y_},
          {"text", texts_},
          {"showlegend", false},
          {"hovertemplate", StrCat("%{text}: ", what_, " in frame %{x}<extra></extra>")},
          {"marker",
           {{"symbol", symbol_},
            {"size", 9},
            {"color", colours_},
            {"line", {{"color", colours_}, {"width", 2}}}}}};
}

}  // namespace cvo::reports
