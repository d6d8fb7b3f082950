// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/check_runs.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text_file.h"
#include "reports/gate/compare.h"
#include "reports/gate/gate_runs.h"
#include "reports/tables/table_parts.h"

namespace cvo::reports {
namespace {

using Place = std::pair<std::map<std::string, std::string>, std::uint64_t>;

std::vector<std::string> MetricNames(const Baseline& baseline) {
  std::vector<std::string> names;
  for (const BaselineMetric& metric : baseline.metrics) names.push_back(metric.name);
  return names;
}

class Check {
 public:
  Check(const GateRuns& runs, const Baseline& baseline)
      : baseline_(baseline), runs_(runs), time_ratios_(TimeRatios(runs_)) {
    for (const SuiteRun& run : runs_.runs) now_[{run.planned.keys, run.planned.seed}] = &run;
  }

  GateReport Run(bool exact) {
    report_.suite = runs_.suite;
    report_.baseline_commit = baseline_.build.commit;
    report_.baseline_build = baseline_.build.identity;
    CheckUnfinished();
    for (const BaselineJob& job : baseline_.jobs) PairJob(job);
    report_.runs = pairs_.size();
    report_.comparisons = CompareValues(baseline_, pairs_);
    if (report_.comparisons.empty()) Fail(runs_.suite, "nothing was compared");
    if (exact) CountChanges();
    CheckTimes();
    AddNotes();
    return std::move(report_);
  }

 private:
  void Fail(const std::string& where, const std::string& message) {
    report_.problems.push_back({where, message});
  }

  // Reports unfinished runs, whether or not the baseline has them: they were not measured.
  void CheckUnfinished() {
    for (const SuiteRun& run : runs_.runs) {
      if (run.run) continue;
      Fail(RunLabel(run.planned.keys, run.planned.seed),
           run.state + (run.message.empty() ? "" : ": " + run.message));
    }
  }

  void PairJob(const BaselineJob& job) {
    const std::string label = RunLabel(job.keys, job.seed);
    const auto found = now_.find({job.keys, job.seed});
    if (found == now_.end()) {
      const bool wanted = std::find(baseline_.seeds.begin(), baseline_.seeds.end(), job.seed) !=
                          baseline_.seeds.end();
      if (wanted) Fail(label, "in the baseline, but not among the jobs of this folder");
      return;
    }
    const SuiteRun& run = *found->second;
    if (!run.run) return;
    report_.build = run.run->build.identity;
    platforms_.insert(run.run->build.Platform());
    if (job.status == "ok" && run.state != "ok") {
      Fail(label, StrCat("ended as ", run.state, run.message.empty() ? "" : ": " + run.message));
    }
    const int frames = run.run->sequence.frames;
    if (job.frames && frames != *job.frames) {
      return Fail(label, StrCat(frames, " frames, in the baseline ", *job.frames));
    }
    if (!job.content.empty() && run.run->sequence.content != job.content) ++other_images_;
    RunPair pair{&job, {}, std::nullopt};
    for (const BaselineMetric& metric : baseline_.metrics) AddValue(metric, run, label, pair);
    const auto ratio = time_ratios_.find(run.planned.job);
    if (ratio != time_ratios_.end()) pair.time_ratio = ratio->second;
    pairs_.push_back(std::move(pair));
  }

  void AddValue(const BaselineMetric& metric, const SuiteRun& run, const std::string& label,
                RunPair& pair) {
    const bool expected = pair.baseline->values.contains(metric.name);
    const MetricValue* value = FindMetric(*run.run, metric.name);
    if (value == nullptr && expected) Fail(label, StrCat("no ", metric.name));
    if (value != nullptr && !expected) ++new_values_;
    if (value == nullptr || !expected) return;
    if (HasSameMeaning(metric, *run.run, *value)) pair.values[metric.name] = value->value;
  }

  // Reports a difference in contracts once per metric and dataset type.
  bool HasSameMeaning(const BaselineMetric& metric, const RunSummary& run,
                      const MetricValue& value) {
    const auto known = metric.contracts.find(run.sequence.type);
    const Contract contract = GateContract(run, value);
    if (known != metric.contracts.end() && known->second == contract && metric.unit == value.unit) {
      return true;
    }
    if (!refused_.insert({metric.name, run.sequence.type}).second) return false;
    if (known == metric.contracts.end()) {
      Fail(metric.name, StrCat("measured on ", run.sequence.type, ", but not in the baseline"));
    } else if (metric.unit != value.unit) {
      Fail(metric.name,
           StrCat("in ", NameOf(value.unit), ", in the baseline in ", NameOf(metric.unit)));
    } else {
      const std::string field = FirstDifference(contract, known->second);
      Fail(metric.name, StrCat("another contract: ", field, " \"", FieldText(contract, field),
                               "\", in the baseline \"", FieldText(known->second, field), "\""));
    }
    return false;
  }

  // The same estimator gives the same values, but another platform may round differently.
  void CountChanges() {
    const std::string& platform = baseline_.build.platform;
    if (!platform.empty() && platforms_ == std::set<std::string>{platform}) {
      report_.changed = report_.Differing();
      return;
    }
    report_.notes.push_back(StrCat("exactness is not checked: the platform is not the baseline's (",
                                   Joined(platforms_, "; "),
                                   "; baseline: ", platform.empty() ? "unknown" : platform, ")"));
  }

  void CheckTimes() {
    report_.times = CompareTimes(pairs_);
    std::set<std::string> missing;
    for (const RunPair& pair : pairs_) {
      const std::string& variant = pair.baseline->keys.at("variant");
      if (pair.baseline->time_ratio && !pair.time_ratio) missing.insert(variant);
    }
    for (const std::string& variant : missing) {
      report_.time_problems.push_back(
          StrCat("no time of ", variant, " against ", kTimeReference, " in some runs"));
    }
  }

  void AddNotes() {
    std::set<Place> known;
    for (const BaselineJob& job : baseline_.jobs) known.insert({job.keys, job.seed});
    const auto more = std::count_if(now_.begin(), now_.end(),
                                    [&](const auto& run) { return !known.contains(run.first); });
    const auto note = [this](auto count, const char* what) {
      if (count > 0) report_.notes.push_back(StrCat(count, what));
    };
    note(more, " jobs are not in the baseline");
    note(new_values_, " values are of metrics that the baseline lacks for their job");
    std::set<std::string> levels = CpuLevels(runs_.runs);
    levels.insert(baseline_.build.cpu_level);
    if (levels.size() > 1) report_.notes.push_back(CpuLevelNote(levels));
    note(other_images_,
         " runs read other images than the baseline (other frames, or scenes that render "
         "differently): verdicts do not compare like with like");
  }

  const Baseline& baseline_;
  const GateRuns& runs_;
  std::map<std::string, double> time_ratios_;
  std::map<Place, const SuiteRun*> now_;
  std::vector<RunPair> pairs_;
  std::set<std::string> platforms_;
  std::set<std::pair<std::string, std::string>> refused_;
  std::size_t new_values_ = 0;
  std::size_t other_images_ = 0;
  GateReport report_;
};

}  // namespace

GateReport CheckRuns(const std::filesystem::path& folder, const Baseline& baseline, bool exact) {
  return Check(ReadGateRuns(folder, MetricNames(baseline)), baseline).Run(exact);
}

std::vector<LostPart> CheckInPlaceOf(const std::string& variant,
                                     const std::filesystem::path& folder, const Baseline& baseline,
                                     bool exact) {
  Baseline of_variant = baseline;
  std::erase_if(of_variant.jobs, [&](const BaselineJob& job) {
    return !job.keys.contains("variant") || job.keys.at("variant") != variant;
  });
  if (of_variant.jobs.empty()) {
    ThrowError("variant " + Quoted(variant), "no run of it in the baseline", "one that is in it");
  }
  const GateRuns all = ReadGateRuns(folder, MetricNames(baseline));
  std::vector<std::string> variants;
  for (const SuiteRun& run : all.runs) AddOnce(KeyOf(run.planned, "variant"), variants);
  std::vector<LostPart> parts;
  for (const std::string& other : variants) {
    GateRuns runs = all;
    std::erase_if(runs.runs,
                  [&](const SuiteRun& run) { return KeyOf(run.planned, "variant") != other; });
    for (SuiteRun& run : runs.runs) run.planned.keys["variant"] = variant;
    parts.push_back({other, Check(runs, of_variant).Run(exact)});
  }
  return parts;
}

}  // namespace cvo::reports
