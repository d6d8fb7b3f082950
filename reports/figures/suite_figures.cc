// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite_figures.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/suite_parts.h"
#include "reports/tables/make_table.h"

namespace cvo::reports {
namespace {

// Minus the number of options, among those that the suite varies, that the run does not leave at
// their defaults.
int OptionsAtDefault(const PlannedRun& run, const Table& table) {
  return -static_cast<int>(std::count_if(run.keys.begin(), run.keys.end(), [&](const auto& key) {
    if (!IsOption(key.first)) return false;
    const auto* option = FindBy(table.provenance.options, &ChangedOption::path, key.first);
    return option == nullptr || option->default_value != key.second;
  }));
}

std::set<std::string> ValuesOf(const SuitePlan& plan, const std::string& key) {
  std::set<std::string> values;
  for (const PlannedRun& run : plan.runs) values.insert(KeyOf(run, key));
  return values;
}

// A run to be drawn, without what it estimates.
DrawnRun Describe(const SuitePlan& plan, const PlannedRun& run) {
  DrawnRun drawn;
  drawn.sequence = KeyOf(run, "sequence");
  if (ValuesOf(plan, "detections").size() > 1) {
    drawn.sequence += ", detections " + KeyOf(run, "detections");
  }
  drawn.variant = KeyOf(run, "variant");
  const std::string oracle = KeyOf(run, "oracle");
  if (oracle != "none" && oracle != "default") drawn.variant += ", oracle " + oracle;
  drawn.seed = run.seed;
  drawn.job = run.job;
  return drawn;
}

// The run to draw per sequence and variant.
struct Choice {
  std::pair<std::string, std::string> key;
  int score = 0;
  const SuiteRun* run = nullptr;
  DrawnRun drawn;
};

std::vector<Choice> ChooseRuns(const SuiteData& data) {
  std::vector<Choice> choices;
  for (const SuiteRun& run : data.runs) {
    if (!run.run || !run.planned.system.empty()) continue;
    const DrawnRun drawn = Describe(data.plan, run.planned);
    const Choice fresh{
        {drawn.sequence, drawn.variant}, OptionsAtDefault(run.planned, data.table), &run, drawn};
    Choice& known = FindOrAdd(choices, &Choice::key, fresh);
    if (fresh.score > known.score) known = fresh;
  }
  return choices;
}

// Runs that cannot be drawn, or not in full, by the reason.
using Reason = std::pair<std::string, std::vector<std::string>>;

void ReadDrawn(Choice& choice, SuiteData& data, std::vector<Reason>& reasons) {
  DrawnRun& drawn = choice.drawn;
  const auto add = [&](const std::string& reason) {
    FindOrAdd(reasons, &Reason::first, {reason, {}})
        .second.push_back(StrCat(drawn.sequence, " ", drawn.variant, " seed ", drawn.seed));
  };
  const std::filesystem::path folder = choice.run->run->file.parent_path();
  try {
    drawn.detail = ReadRunDetail(folder);
    data.drawn.push_back(drawn);
    for (const std::string& missing : drawn.detail.missing) add(missing);
    if (drawn.detail.bodies.empty()) return;
    const std::filesystem::path landmarks = folder / "landmarks.csv";
    if (!std::filesystem::exists(landmarks)) return add("landmarks.csv: no such file");
    data.drawn.back().switches =
        IdentitySwitches(ReadLandmarks(landmarks, LandmarkLabel::kCluster), drawn.detail.bodies);
  } catch (const Error& error) {
    add(error.what());
  }
}

std::vector<std::string> KeysByScene(const Table& table) {
  std::vector<std::string> keys = table.keys;
  AddOnce<std::string>("sequence", keys);
  return keys;
}

// Describes what identifies a row apart from its sequence.
SeriesRows DescribeSeries(const std::vector<std::string>& keys,
                          const std::vector<std::string>& values) {
  SeriesRows series;
  const auto add = [](const std::string& text, std::string& list) {
    list += StrCat(list.empty() ? "" : ", ", text);
  };
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == "sequence" || keys[i] == "family") continue;
    const bool option = IsOption(keys[i]);
    add(option ? keys[i] + " " + values[i] : values[i], series.label);
    add(values[i], option ? series.options : series.name);
  }
  return series;
}

// Splits the rows of the table by sequence, in the order of the table, with differences against its
// reference.
std::vector<SeriesRows> SplitByScene(const SuiteData& data) {
  Table table;
  table.keys = KeysByScene(data.table);
  table.columns = data.table.columns;
  table.reference = data.table.reference;
  SuitePlan plan = data.plan;
  plan.rows = table.keys;
  const std::string reference = FullReference(plan);
  const std::vector<RowRuns> rows = GroupRuns(data.runs, table.keys);
  AddRows(
      rows, ".",
      [&](const RowRuns& row) { return FindReference(rows, row, table.keys, reference); }, table);
  const auto sequence = static_cast<std::size_t>(
      std::find(table.keys.begin(), table.keys.end(), "sequence") - table.keys.begin());
  std::vector<SeriesRows> series;
  for (Row& row : table.rows) {
    SeriesRows described = DescribeSeries(table.keys, row.keys);
    if (described.name.empty()) described.name = OneVariant(data.plan);
    FindOrAdd(series, &SeriesRows::label, std::move(described))
        .scenes.push_back({row.keys[sequence], std::move(row.cells)});
  }
  if (table.keys.size() == data.table.keys.size()) return series;
  for (const Row& row : data.table.rows) {
    SeriesRows* known =
        FindBy(series, &SeriesRows::label, DescribeSeries(data.table.keys, row.keys).label);
    if (known != nullptr) known->all = &row;
  }
  return series;
}

}  // namespace

SuiteData ReadSuiteData(const std::filesystem::path& folder, const Table& table) {
  SuiteData data;
  data.plan = ReadPlan(folder / "plan.json");
  data.table = table;
  std::vector<std::string> metrics;
  for (const Column& column : table.columns) metrics.push_back(column.metric);
  data.runs = ReadRuns(folder, data.plan, metrics);
  std::vector<Reason> reasons;
  for (Choice& choice : ChooseRuns(data)) ReadDrawn(choice, data, reasons);
  for (const auto& [reason, runs] : reasons) {
    data.not_drawn.push_back(
        StrCat(reason, " (", runs.front(),
               runs.size() > 1 ? StrCat(" and ", Counted(runs.size() - 1, "more run")) : "", ")."));
  }
  return data;
}

bool IsOption(const std::string& key) {
  constexpr std::array kNonOptionKeys = {"sequence", "family", "detections", "variant", "oracle"};
  return std::find(kNonOptionKeys.begin(), kNonOptionKeys.end(), key) == kNonOptionKeys.end();
}

std::string OneVariant(const SuitePlan& plan) {
  const std::set<std::string> variants = ValuesOf(plan, "variant");
  return variants.size() == 1 ? *variants.begin() : "all variants";
}

Palette PaletteOf(const SuitePlan& plan, const std::vector<std::string>& others) {
  std::vector<std::string> names;
  for (const PlannedRun& run : plan.runs) names.push_back(KeyOf(run, "variant"));
  names.insert(names.end(), others.begin(), others.end());
  return Palette(names);
}

Palette PaletteOfDrawn(const SuiteData& data) {
  std::vector<std::string> variants;
  for (const DrawnRun& run : data.drawn) variants.push_back(run.variant);
  return PaletteOf(data.plan, variants);
}

std::vector<DrawnScene> GroupByScene(const std::vector<DrawnRun>& runs) {
  std::vector<DrawnScene> scenes;
  for (const DrawnRun& run : runs) {
    FindOrAdd(scenes, &DrawnScene::sequence, {run.sequence, {}}).runs.push_back(&run);
  }
  return scenes;
}

std::string SceneText(const DrawnScene& scene) {
  std::set<std::uint64_t> seeds;
  for (const DrawnRun* run : scene.runs) seeds.insert(run->seed);
  return StrCat(scene.sequence, seeds.size() > 1 ? ", seeds " : ", seed ", Joined(seeds, ", "),
                ". Truth aligned by the camera (rotation: mean over its orientations, "
                "translation: over its positions), one rigid offset per body");
}

void Track::Add(int frame, double x, double y) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  if (!data.empty() && frame > last + 1) data.push_back({kGap, kGap});
  data.push_back({x, y});
  last = frame;
}

void AddWithBand(Series line, std::vector<Series>& series) {
  Series band = line;
  band.kind = SeriesKind::kBand;
  band.name.clear();
  band.look.opacity = 0.18;
  series.push_back(std::move(band));
  series.push_back(std::move(line));
}

std::optional<ValueRange> IntervalOf(const std::optional<Interval>& interval, double scale,
                                     double base) {
  if (!interval) return std::nullopt;
  return ValueRange{base + scale * interval->low, base + scale * interval->high};
}

SuiteFigures MakeSuiteFigures(const SuiteData& data) {
  constexpr std::size_t kMaxSceneRows = 400;
  SuiteFigures figures;
  const std::size_t rows = GroupRuns(data.runs, KeysByScene(data.table)).size();
  if (rows <= kMaxSceneRows) {
    const std::vector<SeriesRows> series = SplitByScene(data);
    AddErrorReduction(data, series, figures);
    AddErrorOverCoverage(data, series, figures);
  } else {
    figures.not_drawn.push_back(
        StrCat("Change in error by sequence, and error over coverage: ", rows,
               " rows of the table by sequence, at most ", kMaxSceneRows, " can be read."));
  }
  AddWaterfall(data, figures);
  AddSensitivity(data, figures);
  AddErrorOverTime(data, figures);
  AddTrajectories(data, figures);
  AddCalibration(data, figures);
  AddStageTimes(data, figures);
  // Names of sequences that differ only in punctuation give figures the same name.
  std::map<std::string, int> seen;
  for (Figure& figure : figures.figures) {
    const int count = ++seen[figure.name];
    if (count > 1) figure.name += StrCat("-", count);
  }
  figures.not_drawn.insert(figures.not_drawn.end(), data.not_drawn.begin(), data.not_drawn.end());
  return figures;
}

}  // namespace cvo::reports
