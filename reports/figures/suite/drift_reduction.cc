// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <map>

#include "core/base/error.h"
#include "reports/figures/heat_map.h"
#include "reports/figures/numbers.h"
#include "reports/figures/suite/suite_parts.h"
#include "reports/results/metric_catalogue.h"

namespace cvo::reports {
namespace {

constexpr std::array<const char*, 4> kErrors = {"translation", "roll", "pitch", "yaw"};

// The drifts of a system on a sequence that one source published: of the camera and of bodies, for
// some of kErrors.
struct PublishedDrift {
  std::size_t source = 0;
  std::string sequence;
  std::string system;
  std::vector<const ReferenceFigure*> figures;
};

std::size_t IndexOf(const ReferenceFigure& figure) {
  return MaxDriftIndex(FindEntry(figure.metric)->id).value();
}

std::string RowOf(const ReferenceFigure& figure) {
  return figure.body.empty() ? "camera" : figure.body;
}

std::vector<PublishedDrift> PublishedDrifts(const Reference& reference) {
  std::vector<PublishedDrift> all;
  for (const ReferenceFigure& figure : reference.figures) {
    const MetricEntry* entry = FindEntry(figure.metric);
    if (entry == nullptr || !MaxDriftIndex(entry->id)) continue;
    const auto found = std::find_if(all.begin(), all.end(), [&](const PublishedDrift& drift) {
      return drift.source == figure.source && drift.sequence == figure.sequence &&
             drift.system == figure.system;
    });
    if (found != all.end()) {
      found->figures.push_back(&figure);
    } else {
      all.push_back({figure.source, figure.sequence, figure.system, {&figure}});
    }
  }
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

HeatCell DriftCell(const RunSummary& run, const ReferenceFigure& figure) {
  HeatCell cell;
  const std::string unit = StrCat(" ", NameOf(figure.unit));
  const std::optional<double> ours = OurDrift(run, figure);
  cell.hover = StrCat(ours ? NumberText(*ours) + unit : "no value", " against ",
                      NumberText(figure.value), unit);
  if (!ours || figure.value <= 0.0) return cell;
  cell.reduction_percent = 100.0 * (1.0 - *ours / figure.value);
  cell.text = HeatText(*cell.reduction_percent);
  return cell;
}

HeatBlock DriftBlock(const std::string& variant, const RunSummary& run,
                     const PublishedDrift& published, const std::vector<std::size_t>& errors) {
  HeatBlock block{variant, {}};
  for (const ReferenceFigure* figure : published.figures) {
    if (block.rows.empty() || block.rows.back().label != RowOf(*figure)) {
      block.rows.push_back({RowOf(*figure), std::vector<HeatCell>(errors.size())});
    }
    const auto column = std::find(errors.begin(), errors.end(), IndexOf(*figure) % 4);
    block.rows.back().cells[static_cast<std::size_t>(column - errors.begin())] =
        DriftCell(run, *figure);
  }
  return block;
}

std::string BlockText(const HeatBlock& block) {
  std::string text = StrCat(" ", block.label, ":");
  for (const HeatRow& row : block.rows) {
    text += StrCat(" ", row.label);
    for (const HeatCell& cell : row.cells) text += " " + (cell.text.empty() ? "none" : cell.text);
    text += ";";
  }
  text.back() = '.';
  return text;
}

Figure DriftFigure(const PublishedDrift& published, const ReferenceSource& source,
                   const std::vector<HeatBlock>& blocks, const std::vector<std::size_t>& errors) {
  std::vector<HeatColumn> columns;
  for (const std::size_t error : errors) columns.push_back({kErrors[error], kErrors[error]});
  const Plot plot = DrawHeatMap(blocks, columns);
  Figure figure;
  figure.id = Slug(StrCat("drift-reduction-", published.system, "-", source.id));
  figure.group = "Change in error";
  figure.title =
      StrCat("Maximum drift on ", published.sequence, " against ", published.system,
             " as published, in percent. ", Capitalised(published.figures.front()->metric));
  figure.caption = StrCat("Blue and −: less drift than ", published.system,
                          "; orange and +: more. One run each. Source: ", source.source, ". ",
                          Capitalised(source.caveat), ".");
  figure.alt = "Heat map, in percent of the published drift.";
  for (const HeatBlock& block : blocks) figure.alt += BlockText(block);
  figure.width_px = HeatMapWidth(blocks, columns.size(), 70);
  figure.least_px = figure.width_px;
  figure.height_px = plot.height_px();
  figure.plotly = plot.Text();
  return figure;
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

void DrawDriftReduction(const SuiteData& data, SuiteDrawing& drawing) {
  const Reference reference = ShippedReference();
  for (const PublishedDrift& published : PublishedDrifts(reference)) {
    const ReferenceFigure& first = *published.figures.front();
    std::vector<std::size_t> errors;
    for (std::size_t i = 0; i < kErrors.size(); ++i) {
      const auto is = [i](const ReferenceFigure* figure) { return IndexOf(*figure) % 4 == i; };
      if (std::any_of(published.figures.begin(), published.figures.end(), is)) errors.push_back(i);
    }
    std::vector<HeatBlock> blocks;
    for (const DrawnRun& drawn : data.drawn) {
      const RunSummary* run = RunOn(published.sequence, drawn, data);
      if (run == nullptr) continue;
      if (run->sequence.first_frame != first.first_frame || run->sequence.frames != first.frames) {
        drawing.not_drawn.push_back(StrCat("Maximum drift against ", published.system,
                                           ": published of frames ", first.first_frame, ":",
                                           first.first_frame + first.frames, " alone."));
        break;
      }
      blocks.push_back(DriftBlock(drawn.variant, *run, published, errors));
    }
    if (blocks.empty()) continue;
    drawing.figures.push_back(
        DriftFigure(published, reference.sources[published.source], blocks, errors));
  }
}

}  // namespace cvo::reports
