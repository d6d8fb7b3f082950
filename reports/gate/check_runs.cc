// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/check_runs.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/utf8.h"
#include "core/record/metric_catalogue.h"
#include "reports/statistics/estimate.h"

namespace cvo::reports {
namespace {

// One metric over the pairs of one variant on one scene.
struct ScenePairs {
  RunKeys keys;
  std::vector<double> baseline;
  std::vector<double> now;
  double seed_variance = 0.0;  // of a single run of the baseline
  std::size_t seeds = 0;
};

// A comparison whose tolerance is not known until all comparisons have been counted.
struct Candidate {
  Comparison comparison;
  std::vector<ScenePairs> scenes;
};

// Fills in the spread between all seeds of the baseline: at least that of one run that is off by
// one step of MetricEntry::Resolution.
void AddSpread(const Baseline& baseline, const std::string& metric, ScenePairs& scene) {
  std::vector<double> values;
  for (const BaselineJob& job : baseline.jobs) {
    const auto value = job.values.find(metric);
    if (job.keys == scene.keys && value != job.values.end()) values.push_back(value->second);
  }
  scene.seeds = values.size();
  if (values.size() < 2) return;
  const auto count = static_cast<double>(values.size());
  const double step = FindEntry(metric)->Resolution(MeanOf(values));
  scene.seed_variance = std::max(SquaresAroundMean(values) / (count - 1.0), step * step / count);
}

// Without scenes of one seed, whose spread is not known.
std::vector<ScenePairs> GatherScenes(const Baseline& baseline, const std::string& metric,
                                     const std::string& variant,
                                     const std::vector<RunPair>& pairs) {
  std::vector<ScenePairs> scenes;
  for (const RunPair& pair : pairs) {
    const auto now = pair.values.find(metric);
    const auto then = pair.baseline->values.find(metric);
    if (pair.baseline->keys.at("variant") != variant || now == pair.values.end() ||
        then == pair.baseline->values.end()) {
      continue;
    }
    ScenePairs& scene = FindOrAdd(scenes, &ScenePairs::keys, {pair.baseline->keys, {}, {}});
    scene.baseline.push_back(then->second);
    scene.now.push_back(now->second);
  }
  for (ScenePairs& scene : scenes) AddSpread(baseline, metric, scene);
  std::erase_if(scenes, [](const ScenePairs& scene) { return scene.seeds < 2; });
  return scenes;
}

// Twice the variance, because both the baseline and the checked runs are random draws.
Comparison Judge(const Candidate& candidate, std::size_t comparisons) {
  Comparison comparison = candidate.comparison;
  const auto scenes = static_cast<double>(candidate.scenes.size());
  double variance = 0.0;
  std::size_t seeds = candidate.scenes.front().seeds;
  bool same = true;
  for (const ScenePairs& scene : candidate.scenes) {
    comparison.baseline += MeanOf(scene.baseline) / scenes;
    comparison.now += MeanOf(scene.now) / scenes;
    comparison.pairs += scene.now.size();
    variance +=
        2.0 * scene.seed_variance / static_cast<double>(scene.now.size()) / (scenes * scenes);
    seeds = std::min(seeds, scene.seeds);
    same = same && scene.now == scene.baseline;
  }
  const double tail = std::max(kFalseAlarms / static_cast<double>(comparisons), 1e-9);
  comparison.tolerance = StudentQuantile(tail, static_cast<int>(seeds) - 1) * std::sqrt(variance);
  const bool higher_is_better = FindEntry(comparison.metric)->higher_is_better();
  const double worse_by = higher_is_better ? -comparison.difference() : comparison.difference();
  comparison.verdict = same                               ? Verdict::kSame
                       : worse_by > comparison.tolerance  ? Verdict::kWorse
                       : worse_by < -comparison.tolerance ? Verdict::kBetter
                                                          : Verdict::kWithin;
  return comparison;
}

class Check {
 public:
  Check(const GateRuns& runs, const Baseline& baseline) : baseline_(baseline), runs_(runs) {}

  GateReport Run(bool exact) {
    report_.suite = runs_.suite;
    report_.baseline_commit = baseline_.build.commit;
    // Unfinished runs fail, whether or not the baseline has them: they were not measured.
    for (const SuiteRun& run : runs_.runs) {
      if (!run.run) Fail(RunLabel(run.planned.keys, run.planned.seed), run.state, run.message);
    }
    for (const BaselineJob& job : baseline_.jobs) PairJob(job);
    report_.runs = pairs_.size();
    report_.comparisons = CompareValues(baseline_, pairs_);
    if (report_.comparisons.empty()) Fail(runs_.suite, "nothing was compared");
    CheckPlatform(exact);
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
    platforms_.insert(run->run->build.Platform());
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

  // The same estimator gives the same values, but another platform may round differently.
  void CheckPlatform(bool exact) {
    const std::string& platform = baseline_.build.platform;
    const bool same = platforms_ == std::set<std::string>{platform};
    if (exact && same && !platform.empty()) {
      report_.changed = report_.comparisons.size() - report_.Count(Verdict::kSame);
    } else if (exact || (!same && !platforms_.empty())) {
      report_.notes.push_back(StrCat(
          "exactness is not checked: the platform is not the baseline's (",
          Joined(platforms_, "; "), "; baseline: ", platform.empty() ? "unknown" : platform, ")"));
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
    if (report_.Count(Verdict::kBetter) > 0) {
      report_.notes.emplace_back(
          "better than the baseline by more than the tolerance: update the baseline to hold this "
          "level");
    }
  }

  const Baseline& baseline_;
  const GateRuns& runs_;
  std::vector<RunPair> pairs_;
  std::set<std::string> platforms_;
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
  return Check(ReadGateRuns(folder, metrics), baseline).Run(exact);
}

std::vector<Comparison> CompareValues(const Baseline& baseline, const std::vector<RunPair>& pairs) {
  std::vector<std::string> variants;
  for (const RunPair& pair : pairs) AddOnce(pair.baseline->keys.at("variant"), variants);
  std::vector<Candidate> candidates;
  for (const std::string& variant : variants) {
    for (const BaselineMetric& metric : baseline.metrics) {
      const std::vector<ScenePairs> scenes = GatherScenes(baseline, metric.name, variant, pairs);
      if (scenes.empty()) continue;
      const Comparison empty{
          .variant = variant, .scene = "", .metric = metric.name, .unit = NameOf(metric.unit)};
      candidates.push_back({empty, scenes});
      if (scenes.size() == 1) continue;
      for (const ScenePairs& scene : scenes) {
        candidates.push_back({empty, {scene}});
        candidates.back().comparison.scene = SceneLabel(scene.keys);
      }
    }
  }
  std::vector<Comparison> comparisons;
  for (const Candidate& candidate : candidates) {
    comparisons.push_back(Judge(candidate, candidates.size()));
  }
  return comparisons;
}

}  // namespace cvo::reports
