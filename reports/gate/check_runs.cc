// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/check_runs.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/utf8.h"
#include "core/files/text_file.h"

namespace cvo::reports {
namespace {

class Check {
 public:
  Check(const GateRuns& runs, const Baseline& baseline, bool exact)
      : baseline_(baseline), runs_(runs), exact_(exact) {}

  GateReport Run() {
    report_.suite = runs_.suite;
    report_.baseline_commit = baseline_.build.commit;
    // Unfinished runs fail, whether or not the baseline has them: they were not measured.
    for (const SuiteRun& run : runs_.runs) {
      if (!run.run) Fail(RunLabel(run.planned.keys, run.planned.seed), run.state, run.message);
    }
    for (const BaselineJob& job : baseline_.jobs) PairJob(job);
    report_.runs = pairs_.size();
    report_.comparisons = CompareValues(baseline_, pairs_);
    if (report_.comparisons.size() == report_.Count(Verdict::kBlind)) {
      Fail(runs_.suite, "nothing was compared");
    }
    AddNotes();
    return std::move(report_);
  }

 private:
  void Fail(const std::string& where, const std::string& what, const std::string& why = "") {
    report_.problems.push_back(Printable(StrCat(where, ": ", what, why.empty() ? "" : ": " + why)));
  }

  void PairJob(const BaselineJob& job) {
    const std::string label = RunLabel(job.keys, job.seed);
    const SuiteRun* run = nullptr;
    for (const SuiteRun& other : runs_.runs) {
      if (other.planned.seed == job.seed && other.planned.keys == job.keys) run = &other;
    }
    if (run == nullptr) {
      if (std::count(baseline_.seeds.begin(), baseline_.seeds.end(), job.seed) > 0) {
        Fail(label, "in the baseline, but not among the jobs of this folder");
      }
      return;
    }
    ++known_;
    if (!run->run) return;
    const std::string platform = run->run->build.Platform();
    const bool exact = exact_ && platform == baseline_.build.platform && !platform.empty();
    if (platform != baseline_.build.platform) AddOnce(platform, platforms_);
    AddOptions(*run->run);
    if (job.status == "ok" && run->state != "ok")
      Fail(label, "ended as " + run->state, run->message);
    const RunSequence& sequence = run->run->sequence;
    if (job.frames && sequence.frames != *job.frames) {
      return Fail(label, StrCat(sequence.frames, " frames, in the baseline ", *job.frames));
    }
    if (!job.content.empty() && sequence.content != job.content) ++other_images_;
    RunPair pair{&job, {}};
    for (const BaselineMetric& metric : baseline_.metrics) {
      const bool expected = job.values.contains(metric.name);
      const MetricValue* value = FindMetric(*run->run, metric.name);
      if (value == nullptr && expected) Fail(label, "no " + metric.name);
      if (value != nullptr && !expected) ++new_values_;
      if (value == nullptr || !expected || !HasSameMeaning(metric, *run->run, *value)) continue;
      pair.values[metric.name] = value->value;
      report_.exact += exact ? 1 : 0;
      report_.changed += exact && value->value != job.values.at(metric.name) ? 1 : 0;
    }
    pairs_.push_back(std::move(pair));
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

  void AddOptions(const RunSummary& run) {
    const std::map<std::string, std::string> options = FlatJson(run.options);
    for (const auto& [path, value] : baseline_.options) {
      const auto found = options.find(path);
      const std::string now = found == options.end() ? "none" : found->second;
      if (now != value)
        AddOnce(StrCat("option ", path, " is ", now, ", in the baseline ", value), report_.notes);
    }
  }

  void AddNotes() {
    const auto note = [this](std::size_t count, const char* what) {
      if (count > 0) report_.notes.push_back(StrCat(count, what));
    };
    note(runs_.runs.size() - known_, " jobs are not in the baseline");
    note(new_values_, " values are of metrics that the baseline lacks for their job");
    note(other_images_,
         " runs read other images than the baseline (other frames, or scenes that render "
         "differently): verdicts do not compare like with like");
    if (!platforms_.empty()) {
      const std::string& platform = baseline_.build.platform;
      report_.notes.push_back(StrCat(
          "exactness is not checked of runs on other platforms than the baseline's (",
          Joined(platforms_, "; "), "; baseline: ", platform.empty() ? "unknown" : platform, ")"));
    }
    AddBlind();
    if (report_.Count(Verdict::kBetter) > 0) {
      report_.notes.emplace_back(
          "better than the baseline by more than the tolerance: update the baseline to hold this "
          "level");
    }
  }

  void AddBlind() {
    constexpr std::size_t kTold = 3;
    std::vector<std::string> blind;
    for (const Comparison& comparison : report_.comparisons) {
      if (comparison.verdict != Verdict::kBlind) continue;
      blind.push_back(StrCat(comparison.metric, " of ", comparison.variant, " on ",
                             comparison.scene.empty() ? "all scenes" : comparison.scene));
    }
    if (blind.empty()) return;
    const std::size_t count = blind.size();
    blind.resize(std::min(count, kTold));
    report_.notes.push_back(StrCat(Counted(count, "comparison"),
                                   " not counted, because their seeds differ too much for any "
                                   "value to fail: ",
                                   Joined(blind, "; "), count > kTold ? "; ..." : ""));
  }

  const Baseline& baseline_;
  const GateRuns& runs_;
  const bool exact_;
  std::vector<RunPair> pairs_;
  std::vector<std::string> platforms_;  // other than the baseline's
  std::set<std::pair<std::string, std::string>> refused_;
  std::size_t known_ = 0;
  std::size_t new_values_ = 0;
  std::size_t other_images_ = 0;
  GateReport report_;
};

}  // namespace

std::size_t GateReport::Count(Verdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(comparisons.begin(), comparisons.end(),
                    [&](const Comparison& comparison) { return comparison.verdict == verdict; }));
}

GateReport CheckRuns(const std::filesystem::path& folder, const Baseline& baseline, bool exact) {
  std::vector<std::string> metrics;
  for (const BaselineMetric& metric : baseline.metrics) metrics.push_back(metric.name);
  const GateRuns runs = ReadGateRuns(folder, metrics);
  if (runs.suite != baseline.suite) {
    ThrowError(folder.string(), "the suite " + Quoted(runs.suite),
               StrCat("the baseline's, ", Quoted(baseline.suite)));
  }
  return Check(runs, baseline, exact).Run();
}

}  // namespace cvo::reports
