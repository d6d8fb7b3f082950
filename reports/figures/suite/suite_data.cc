// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/numbers.h"
#include "reports/figures/suite/suite_figures.h"
#include "reports/figures/suite/swept_lines.h"

namespace cvo::reports {
namespace {

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

}  // namespace cvo::reports
