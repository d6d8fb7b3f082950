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

namespace cvo::reports {
namespace {

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

// Runs that cannot be drawn, or not in full, by the reason.
using Reason = std::pair<std::string, std::vector<std::string>>;

// Reasons name files from the run's folder on, so that the same one of many runs is told once.
void ReadDrawn(DrawnRun drawn, const std::filesystem::path& folder, SuiteData& data,
               std::vector<Reason>& reasons) {
  const std::string place = folder.filename().string() + "/";
  const auto add = [&](std::string reason) {
    const std::size_t at = reason.find(place);
    if (at != std::string::npos) reason.erase(0, at + place.size());
    FindOrAdd(reasons, &Reason::first, {reason, {}})
        .second.push_back(StrCat(drawn.sequence, " ", drawn.variant, " seed ", drawn.seed));
  };
  try {
    drawn.detail = ReadRunDetail(folder);
    data.drawn.push_back(drawn);
    for (const std::string& missing : drawn.detail.missing) add(missing);
  } catch (const Error& error) {
    add(error.what());
  }
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
  std::set<std::pair<std::string, std::string>> seen;
  for (const SuiteRun& run : data.runs) {
    if (!run.run || !run.planned.system.empty()) continue;
    const DrawnRun drawn = Describe(data.plan, run.planned);
    if (!seen.emplace(drawn.sequence, drawn.variant).second) continue;
    ReadDrawn(drawn, run.run->file.parent_path(), data, reasons);
  }
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

SuiteFigures MakeSuiteFigures(const SuiteData& data) {
  SuiteFigures figures;
  AddAblation(data, figures);
  AddSensitivity(data, figures);
  AddErrorOverTime(data, figures);
  AddTrajectories(data, figures);
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
