// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/record/metric_catalogue.h"
#include "reports/figures/numbers.h"
#include "reports/figures/suite_parts.h"
#include "reports/tables/make_table.h"

namespace cvo::reports {
namespace {

// A change against a reference, in percent of its error: negative if the error is smaller.
struct Change {
  std::optional<double> percent;
  bool distinguishable = true;
  std::string tip;
};
struct ChangeRow {
  std::string label;
  std::vector<Change> changes;  // one per column
};
struct ChangeBlock {
  std::string label;
  std::vector<ChangeRow> rows;
};

// "−31" for less error, "+31" for more, and a factor such as "×12" from an increase of 1000 % on.
std::string ChangeText(double change_percent) {
  const double percent = std::round(change_percent);
  if (percent >= 1000.0) return "×" + NumberText(std::round(1.0 + percent / 100.0), 2);
  return (percent < 0.0 ? "−" : percent > 0.0 ? "+" : "") + NumberText(std::abs(percent), 4);
}

// A heat map with the blocks one above the other.
Chart HeatChart(const std::vector<ChangeBlock>& blocks, const std::vector<std::string>& columns) {
  double largest = 10.0;
  std::size_t longest = 0;
  for (const ChangeBlock& block : blocks) {
    for (const ChangeRow& row : block.rows) {
      longest = std::max(longest, std::min<std::size_t>(row.label.size(), 60));
      for (const Change& change : row.changes) {
        largest = std::max(largest, std::abs(change.percent.value_or(0.0)));
      }
    }
  }
  const double limit = std::min(largest, 100.0);
  Chart chart;
  chart.share_x = true;
  chart.width = std::min(1.0, 0.01 * (5.0 + static_cast<double>(longest + 9 * columns.size())));
  for (const ChangeBlock& block : blocks) {
    Panel& panel = chart.panels.emplace_back();
    panel.title = block.label;
    panel.x = {"", AxisScale::kCategory, columns};
    panel.y.scale = AxisScale::kCategory;
    for (const ChangeRow& row : block.rows) {
      const auto y = static_cast<int>(panel.y.categories.size());
      panel.y.categories.push_back(row.label);
      for (std::size_t i = 0; i < row.changes.size(); ++i) {
        const Change& change = row.changes[i];
        if (!change.percent) continue;
        const std::string text = ChangeText(*change.percent);
        panel.cells.push_back(
            {static_cast<int>(i), y, std::clamp(*change.percent / limit, -1.0, 1.0),
             change.distinguishable ? text : "(" + text + ")",
             StrCat(row.label, ", ", block.label, ", ", columns[i], ": ", change.tip),
             change.distinguishable});
      }
    }
  }
  return chart;
}

// For a share that should be large, the error is what is missing to 1.
Change ChangeOf(const Cell& cell, const Column& column) {
  const std::optional<Difference>& difference = cell.difference;
  if (!difference) return {};
  const Shown shown = ShownAs(column.metric, column.unit);
  const std::string unit = shown.unit.empty() ? "" : " " + shown.unit;
  Change change;
  change.distinguishable = difference->distinguishable;
  change.tip = StrCat(NumberText(shown.scale * difference->value), unit, " against ",
                      NumberText(shown.scale * difference->reference_value), unit, ", ",
                      difference->pairs, " pairs");
  const double before =
      shown.is_share ? 1.0 - difference->reference_value : difference->reference_value;
  const double worse = shown.higher_is_better ? -difference->difference : difference->difference;
  if (before > 0.0) change.percent = 100.0 * worse / before;
  return change;
}

bool HasChange(const SceneRow& row) {
  return std::any_of(row.cells.begin(), row.cells.end(),
                     [](const Cell& cell) { return cell.difference.has_value(); });
}

// The columns with a change in at least one row.
std::vector<std::size_t> ChangedColumns(const std::vector<SeriesRows>& series, const Table& table) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto has = [&](const SceneRow& row) {
      return ChangeOf(row.cells[i], table.columns[i]).percent.has_value();
    };
    if (std::any_of(series.begin(), series.end(), [&](const SeriesRows& rows) {
          return std::any_of(rows.scenes.begin(), rows.scenes.end(), has);
        })) {
      columns.push_back(i);
    }
  }
  return columns;
}

std::vector<ChangeBlock> BlocksOf(const std::vector<SeriesRows>& series,
                                  const std::vector<std::size_t>& columns, const Table& table) {
  std::vector<ChangeBlock> blocks;
  for (const SeriesRows& rows : series) {
    ChangeBlock block{rows.label, {}};
    const auto add = [&](const std::string& label, const std::vector<Cell>& cells) {
      ChangeRow& row = block.rows.emplace_back(ChangeRow{label, {}});
      for (const std::size_t i : columns)
        row.changes.push_back(ChangeOf(cells[i], table.columns[i]));
    };
    for (const SceneRow& scene : rows.scenes) {
      if (HasChange(scene)) add(scene.sequence, scene.cells);
    }
    if (rows.all != nullptr && block.rows.size() > 1) add("all", rows.all->cells);
    if (!block.rows.empty()) blocks.push_back(std::move(block));
  }
  return blocks;
}

// The error of a share is what is missing to 1, so its heading is negated, such as "not within
// 10 cm". Another column with the same label is told apart by its unit.
std::string HeadingOf(const Column& column, const Table& table) {
  const auto same = std::count_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& other) { return other.label == column.label; });
  const std::string label = same > 1 ? StrCat(column.label, " (", column.unit, ")") : column.label;
  if (!ShownAs(column.metric, column.unit).is_share) return label;
  return label.starts_with("within ") ? "not " + label : "1 − " + label;
}

constexpr std::array<const char*, 4> kDrifts = {"translation", "roll", "pitch", "yaw"};

// The drifts of a system on a sequence that one source published: of the camera and of bodies, for
// some of kDrifts.
struct PublishedDrift {
  std::size_t source = 0;
  std::string sequence;
  std::string system;
  std::vector<const ReferenceFigure*> figures = {};
  std::vector<std::size_t> errors = {};  // those of kDrifts, ascending
};

std::size_t IndexOf(const ReferenceFigure& figure) {
  return MaxDriftIndex(FindEntry(figure.metric)->id).value();
}

std::vector<PublishedDrift> PublishedDrifts(const Reference& reference) {
  std::vector<PublishedDrift> all;
  for (const ReferenceFigure& figure : reference.figures) {
    const MetricEntry* entry = FindEntry(figure.metric);
    if (entry == nullptr || !MaxDriftIndex(entry->id)) continue;
    const auto id = [](const PublishedDrift& drift) {
      return std::tuple(drift.source, drift.sequence, drift.system);
    };
    PublishedDrift& drift = FindOrAdd(all, id, {figure.source, figure.sequence, figure.system});
    drift.figures.push_back(&figure);
    AddOnce(IndexOf(figure) % kDrifts.size(), drift.errors);
  }
  for (PublishedDrift& drift : all) std::sort(drift.errors.begin(), drift.errors.end());
  return all;
}

std::optional<double> OurDrift(const RunSummary& run, const ReferenceFigure& figure) {
  if (figure.body.empty()) {
    const MetricValue* metric = FindMetric(run, figure.metric);
    return metric == nullptr ? std::nullopt : std::optional(metric->value);
  }
  if (!run.bodies) return std::nullopt;
  for (const BodyRow& body : run.bodies->refined) {
    if (body.name == figure.body && body.max_drift) {
      return body.max_drift->Values().at(IndexOf(figure));
    }
  }
  return std::nullopt;
}

ChangeBlock DriftBlock(const std::string& variant, const RunSummary& run,
                       const PublishedDrift& published) {
  ChangeBlock block{variant, {}};
  for (const ReferenceFigure* figure : published.figures) {
    const std::string body = figure->body.empty() ? "camera" : figure->body;
    if (block.rows.empty() || block.rows.back().label != body) {
      block.rows.push_back({body, std::vector<Change>(published.errors.size())});
    }
    const std::optional<double> ours = OurDrift(run, *figure);
    if (!ours || figure->value <= 0.0) continue;
    const auto column = std::find(published.errors.begin(), published.errors.end(),
                                  IndexOf(*figure) % kDrifts.size());
    const std::string unit = StrCat(" ", NameOf(figure->unit));
    block.rows.back().changes[static_cast<std::size_t>(column - published.errors.begin())] = {
        100.0 * (*ours / figure->value - 1.0), true,
        StrCat(NumberText(*ours), unit, " against ", NumberText(figure->value), unit)};
  }
  return block;
}

// The run behind `drawn`, or nullptr if it is of another sequence.
const RunSummary* RunOn(const std::string& sequence, const DrawnRun& drawn, const SuiteData& data) {
  for (const SuiteRun& run : data.runs) {
    if (run.planned.job != drawn.job || !run.run) continue;
    return run.run->sequence.name == sequence ? &*run.run : nullptr;
  }
  return nullptr;
}

}  // namespace

void AddErrorReduction(const SuiteData& data, const std::vector<SeriesRows>& series,
                       SuiteFigures& figures) {
  constexpr std::size_t kMaxRows = 150;
  const std::string what = "Change in error by sequence: ";
  const Table& table = data.table;
  if (table.reference.empty() || table.change) {
    figures.not_drawn.push_back(what + "the suite names no reference to compare with.");
    return;
  }
  const std::vector<std::size_t> changed = ChangedColumns(series, table);
  const std::vector<ChangeBlock> blocks = BlocksOf(series, changed, table);
  std::size_t rows = 0;
  for (const ChangeBlock& block : blocks) rows += block.rows.size();
  if (changed.empty() || rows > kMaxRows) {
    figures.not_drawn.push_back(
        changed.empty() ? StrCat(what, "no sequence has runs both of the reference ",
                                 table.reference, " and of another.")
                        : StrCat(what, rows, " rows, at most ", kMaxRows, " are drawn."));
    return;
  }
  std::vector<std::string> headings;
  std::vector<const Column*> columns;
  for (const std::size_t i : changed) {
    columns.push_back(&table.columns[i]);
    headings.push_back(HeadingOf(table.columns[i], table));
  }
  figures.figures.push_back(
      {"error-reduction",
       StrCat("Change in error relative to ", table.reference, ", in percent. ",
              Capitalised(RelationText(columns))),
       StrCat("Blue and −: less error than ", table.reference,
              "; orange and +: more, ×12: twelve times as much. In brackets: not distinguishable "
              "from it (the 95 % interval of the paired difference contains 0, its p-value, "
              "corrected for the number of cells, is not below 0.05, or there are too few pairs). "
              "Empty: nothing to compare. For shares, the error is the difference to 100 %. Each "
              "cell is based on what both have in common."),
       HeatChart(blocks, headings)});
}

void AddDriftReduction(const SuiteData& data, SuiteFigures& figures) {
  const Reference reference = ShippedReference();
  for (const PublishedDrift& published : PublishedDrifts(reference)) {
    const ReferenceFigure& first = *published.figures.front();
    const ReferenceSource& source = reference.sources[published.source];
    std::vector<ChangeBlock> blocks;
    for (const DrawnRun& drawn : data.drawn) {
      const RunSummary* run = RunOn(published.sequence, drawn, data);
      if (run == nullptr) continue;
      if (run->sequence.first_frame != first.first_frame || run->sequence.frames != first.frames) {
        figures.not_drawn.push_back(StrCat("Maximum drift against ", published.system,
                                           ": published of frames ", first.first_frame, ":",
                                           first.first_frame + first.frames, " alone."));
        break;
      }
      blocks.push_back(DriftBlock(drawn.variant, *run, published));
    }
    if (blocks.empty()) continue;
    std::vector<std::string> errors;
    for (const std::size_t error : published.errors) errors.push_back(kDrifts[error]);
    figures.figures.push_back(
        {Slug(StrCat("drift-reduction-", published.system, "-", source.id)),
         StrCat("Maximum drift on ", published.sequence, " against ", published.system,
                " as published, in percent. ", Capitalised(first.metric)),
         StrCat("Blue and −: less drift than ", published.system,
                "; orange and +: more. One run each. Source: ", source.source, ". ",
                Capitalised(source.caveat), "."),
         HeatChart(blocks, errors)});
  }
}

}  // namespace cvo::reports
