// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "reports/figures/suite_figures.h"

namespace cvo::test {

using Json = nlohmann::ordered_json;

inline reports::Column ColumnOf(const std::string& metric, const std::string& label,
                                const std::string& unit) {
  reports::Column column{metric, label, unit, {}};
  column.contract.delta = reports::Delta::kNone;
  column.contract.alignment = reports::Alignment::kPositions;
  return column;
}

inline reports::Cell CellOf(double value, double low, double high) {
  reports::Cell cell;
  cell.value = value;
  cell.interval = reports::Interval{low, high};
  return cell;
}

// A suite that sweeps one option of one variant, with object ATE and coverage at each value.
inline reports::SuiteData SweptSuite(const std::string& option, const std::vector<double>& values) {
  reports::SuiteData data;
  data.table.keys = {option};
  data.table.columns = {ColumnOf("object_ate", "object ATE", "m"),
                        ColumnOf("object_coverage", "object coverage", "1")};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string value = Json(values[i]).dump();
    reports::PlannedRun run;
    run.keys = {{"sequence", "room"}, {"variant", "full"}, {option, value}};
    run.job = "job" + std::to_string(i);
    data.plan.runs.push_back(run);
    data.runs.push_back({run, "not run", "", "", std::nullopt});
    reports::Row row;
    row.keys = {value};
    const double ate_m = 0.1 * static_cast<double>(i + 1);
    row.cells = {CellOf(ate_m, ate_m - 0.05, ate_m + 0.05), CellOf(0.5, 0.25, 0.75)};
    data.table.rows.push_back(row);
  }
  data.plan.rows = data.table.keys;
  return data;
}

// A run of frames 0 to 4 with one body, visible and estimated in all frames but 3, where it is
// predicted. Position errors in frames 0 to 4: 1, 2, 3, 4 (predicted) and 5 cm.
inline reports::DrawnRun RunWithBody(const std::string& variant, const std::string& body_name) {
  reports::DrawnRun run;
  run.sequence = "room";
  run.variant = variant;
  run.seed = 1;
  reports::BodyDetail body;
  body.id = 2;
  body.name = body_name;
  body.mover = true;
  body.cluster = 7;
  for (int frame = 0; frame < 5; ++frame) {
    const double at = frame;
    reports::CameraFrame camera;
    camera.frame = frame;
    camera.status = "tracked";
    camera.world_from_camera = {0.1 * at, 9.0, 0.2 * at, 0, 0, 0, 1};
    camera.truth = reports::Pose{0.1 * at, 9.0, 0.2 * at + 0.05, 0, 0, 0, 1};
    run.detail.camera.push_back(camera);
    body.truth.emplace_back(frame, reports::Pose{1.0, 9.0, 3.0 + at, 0, 0, 0, 1});
    const reports::BodyPosition position{frame, {1.0, 9.0, 3.0 + at}, 0.01 * (at + 1.0)};
    (frame == 3 ? body.predicted : body.estimated).push_back(position);
    if (frame != 3) body.visible.push_back(frame);
  }
  run.detail.bodies = {body};
  return run;
}

inline reports::SuiteData DrawnSuite(const std::vector<std::string>& variants,
                                     const std::string& body_name = "ball") {
  reports::SuiteData data;
  data.table.keys = {"variant"};
  data.plan.rows = data.table.keys;
  for (const std::string& variant : variants) {
    reports::PlannedRun run;
    run.keys = {{"sequence", "room"}, {"variant", variant}};
    data.plan.runs.push_back(run);
    data.drawn.push_back(RunWithBody(variant, body_name));
  }
  return data;
}

// Returns the figure with this name, or an empty one.
inline reports::Figure FindFigure(const reports::SuiteFigures& drawn, const std::string& name) {
  for (const reports::Figure& figure : drawn.figures) {
    if (figure.name == name) return figure;
  }
  return {};
}

// Returns the series with data that have this name.
inline std::vector<reports::Series> SeriesNamed(const reports::Chart& chart,
                                                const std::string& name) {
  std::vector<reports::Series> found;
  for (const reports::Panel& panel : chart.panels) {
    for (const reports::Series& series : panel.series) {
      if (series.name == name && !series.data.empty()) found.push_back(series);
    }
  }
  return found;
}

// The coordinates of a series; -1 for a gap.
inline std::vector<double> XsOf(const reports::Series& series) {
  std::vector<double> xs;
  for (const reports::Datum& datum : series.data) xs.push_back(datum.x == datum.x ? datum.x : -1.0);
  return xs;
}
inline std::vector<double> YsOf(const reports::Series& series) {
  std::vector<double> ys;
  for (const reports::Datum& datum : series.data) ys.push_back(datum.y == datum.y ? datum.y : -1.0);
  return ys;
}

}  // namespace cvo::test
