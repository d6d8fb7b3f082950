// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite_figures.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/suite_parts.h"
#include "reports/tables/cells.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxSceneRows = 400;

// The keys of the table, and the sequence.
std::vector<std::string> KeysByScene(const Table& table) {
  std::vector<std::string> keys = table.keys;
  AddOnce<std::string>("sequence", keys);
  return keys;
}

// Minus the number of options, among those that the suite varies, that the run does not leave at
// their defaults.
int OptionsAtDefault(const PlannedRun& run, const Table& table) {
  int count = 0;
  for (const auto& key : run.keys) {
    if (!IsOption(key.first)) continue;
    const auto is_default = [&](const ChangedOption& option) {
      return option.path == key.first && option.default_value == key.second;
    };
    const bool known =
        std::any_of(table.provenance.options.begin(), table.provenance.options.end(), is_default);
    count += known ? 0 : -1;
  }
  return count;
}

bool HasSeveral(const SuitePlan& plan, const std::string& key) {
  std::set<std::string> values;
  for (const PlannedRun& run : plan.runs) values.insert(KeyOf(run, key));
  return values.size() > 1;
}

std::string SequenceOf(const SuitePlan& plan, const PlannedRun& run) {
  std::string name = KeyOf(run, "sequence");
  if (HasSeveral(plan, "detections")) name += ", detections " + KeyOf(run, "detections");
  return name;
}

std::string VariantOf(const PlannedRun& run) {
  const std::string oracle = KeyOf(run, "oracle");
  const std::string variant = KeyOf(run, "variant");
  return oracle == "none" || oracle == "default" ? variant : variant + ", oracle " + oracle;
}

// The run to draw per sequence and variant: the one nearest to the defaults; of several, the first
// in the plan.
std::vector<const SuiteRun*> ChooseRuns(const SuiteData& data) {
  std::vector<std::pair<std::string, std::string>> order;
  std::map<std::pair<std::string, std::string>, std::pair<int, const SuiteRun*>> best;
  for (const SuiteRun& run : data.runs) {
    if (!run.run || run.planned.system) continue;
    const std::pair key(SequenceOf(data.plan, run.planned), VariantOf(run.planned));
    const int score = OptionsAtDefault(run.planned, data.table);
    const auto [found, is_new] = best.try_emplace(key, score, &run);
    if (is_new) order.push_back(key);
    if (score > found->second.first) found->second = {score, &run};
  }
  std::vector<const SuiteRun*> chosen;
  for (const auto& key : order) chosen.push_back(best[key].second);
  return chosen;
}

// Reasons why runs or parts of them cannot be drawn, each with the runs it applies to.
class Reasons {
 public:
  void Add(const std::string& reason, const DrawnRun& run) {
    FindOrAdd(reasons_, &Reason::first, {reason, {}})
        .second.push_back(StrCat(run.sequence, " ", run.variant, " seed ", run.seed));
  }
  std::vector<std::string> Texts() const {
    std::vector<std::string> texts;
    for (const auto& [reason, runs] : reasons_) {
      std::string text = StrCat(reason, " (", runs.front());
      if (runs.size() > 1) text += StrCat(" and ", runs.size() - 1, " more runs");
      texts.push_back(text + ").");
    }
    return texts;
  }

 private:
  using Reason = std::pair<std::string, std::vector<std::string>>;
  std::vector<Reason> reasons_;
};

void ReadDrawn(const SuiteRun& run, SuiteData& data, Reasons& reasons) {
  DrawnRun drawn{SequenceOf(data.plan, run.planned),
                 VariantOf(run.planned),
                 run.planned.seed,
                 run.planned.job,
                 {},
                 std::nullopt};
  const std::filesystem::path folder = run.run->file.parent_path();
  try {
    drawn.detail = ReadRunDetail(folder);
  } catch (const Error& error) {
    reasons.Add(error.what(), drawn);
    return;
  }
  for (const std::string& missing : drawn.detail.missing) reasons.Add(missing, drawn);
  try {
    if (!drawn.detail.bodies.empty()) {
      drawn.switches = ReadIdentitySwitches(folder, drawn.detail.bodies);
    }
  } catch (const Error& error) {
    reasons.Add(error.what(), drawn);
  }
  data.drawn.push_back(std::move(drawn));
}

// Describes what identifies a row apart from its sequence.
SeriesRows Describe(const std::vector<std::string>& keys, const std::vector<std::string>& values) {
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

std::vector<Cell> CellsOf(const RowRuns& row, const RowRuns* reference,
                          const std::vector<std::string>& keys, const Table& table) {
  std::vector<Cell> cells;
  for (const Column& column : table.columns) {
    Cell cell = MakeCell(row, keys, column);
    if (reference != nullptr && cell.present && AreComparable(row, *reference, column)) {
      cell.difference = MakeDifference({keys, row, *reference, table.reference}, column);
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

void CorrectTogether(std::vector<SeriesRows>& series) {
  std::vector<Difference*> differences;
  for (SeriesRows& rows : series) {
    for (SceneRow& scene : rows.scenes) {
      for (Cell& cell : scene.cells) {
        if (cell.difference) differences.push_back(&*cell.difference);
      }
    }
  }
  CorrectForMany(differences);
}

}  // namespace

SuiteData ReadSuiteData(const std::filesystem::path& folder, const Table& table) {
  SuiteData data;
  data.plan = ReadPlan(folder / "plan.json");
  data.table = table;
  std::vector<std::string> metrics;
  for (const Column& column : table.columns) metrics.push_back(column.metric);
  data.runs = ReadRuns(folder, data.plan, metrics);
  Reasons reasons;
  for (const SuiteRun* run : ChooseRuns(data)) ReadDrawn(*run, data, reasons);
  data.not_drawn = reasons.Texts();
  return data;
}

bool IsOption(const std::string& key) {
  constexpr std::array kNonOptionKeys = {"sequence", "family", "detections", "variant", "oracle"};
  return std::find(kNonOptionKeys.begin(), kNonOptionKeys.end(), key) == kNonOptionKeys.end();
}

std::string OneVariant(const SuitePlan& plan) {
  std::set<std::string> variants;
  for (const PlannedRun& run : plan.runs) variants.insert(KeyOf(run, "variant"));
  return variants.size() == 1 ? *variants.begin() : "all variants";
}

Palette PaletteOf(const SuitePlan& plan, const std::vector<std::string>& others) {
  std::vector<std::string> names;
  for (const PlannedRun& run : plan.runs) names.push_back(KeyOf(run, "variant"));
  names.insert(names.end(), others.begin(), others.end());
  return Palette(names);
}

std::vector<SeriesRows> SplitByScene(const SuiteData& data) {
  const std::vector<std::string> keys = KeysByScene(data.table);
  const std::vector<RowRuns> rows = GroupRuns(data.runs, keys);
  SuitePlan plan = data.plan;
  plan.rows = keys;
  const std::string reference = FullReference(plan);
  const auto sequence = std::find(keys.begin(), keys.end(), "sequence") - keys.begin();
  std::vector<SeriesRows> series;
  for (const RowRuns& row : rows) {
    SeriesRows described = Describe(keys, row.keys);
    if (described.name.empty()) described.name = OneVariant(data.plan);
    FindOrAdd(series, &SeriesRows::label, std::move(described))
        .scenes.push_back(
            {row.keys[static_cast<std::size_t>(sequence)],
             CellsOf(row, FindReference(rows, row, keys, reference), keys, data.table)});
  }
  CorrectTogether(series);
  for (const Row& row : data.table.rows) {
    if (keys.size() == data.table.keys.size()) break;
    const std::string label = Describe(data.table.keys, row.keys).label;
    for (SeriesRows& known : series) {
      if (known.label == label) known.all = &row;
    }
  }
  return series;
}

std::vector<DrawnScene> GroupByScene(const std::vector<DrawnRun>& runs) {
  std::vector<DrawnScene> scenes;
  for (const DrawnRun& run : runs) {
    FindOrAdd(scenes, &DrawnScene::sequence, {run.sequence, {}}).runs.push_back(&run);
  }
  return scenes;
}

std::vector<std::string> VariantsOf(const std::vector<DrawnRun>& runs) {
  std::vector<std::string> variants;
  for (const DrawnRun& run : runs) AddOnce(run.variant, variants);
  return variants;
}

std::string SeedText(const DrawnScene& scene) {
  const auto same = [&](const DrawnRun* run) { return run->seed == scene.runs.front()->seed; };
  if (std::all_of(scene.runs.begin(), scene.runs.end(), same)) {
    return StrCat("seed ", scene.runs.front()->seed);
  }
  return "seeds: " + Joined(scene.runs, ", ", [](const DrawnRun* run) {
           return StrCat(run->variant, " ", run->seed);
         });
}

SuiteFigures MakeSuiteFigures(const SuiteData& data) {
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
  AddDriftReduction(data, figures);
  AddSensitivity(data, figures);
  AddErrorOverTime(data, figures);
  AddTrajectories(data, figures);
  AddFrameTracks(data, figures);
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
