// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the gate can tell from noise between seeds.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/record/metric_catalogue.h"
#include "reports/gate/check_runs.h"
#include "reports/statistics/estimate.h"
#include "reports/tables/cells.h"

namespace cvo::reports {
namespace {

constexpr double kLeastError = 1e-6;     // in m or rad; less is as good as none
constexpr double kStep = 0.01;           // MetricEntry::Resolution of an error, as a fraction of it
constexpr double kMostTolerated = 10.0;  // times the value: what no gate may let pass

// One metric over the pairs of one variant on one scene. Errors are given by their logarithm.
struct ScenePairs {
  std::string id;  // tells scenes apart
  std::string label;
  std::vector<std::uint64_t> seeds;
  std::vector<double> baseline;
  std::vector<double> now;
  double variance = 0.0;        // of a single run of the baseline
  std::size_t known_seeds = 0;  // from which that is estimated
};

bool IsRelative(const std::string& metric) { return FindEntry(metric)->kind == MetricKind::kError; }

double Scaled(const std::string& metric, double value) {
  return IsRelative(metric) ? std::log(std::max(value, kLeastError)) : value;
}

std::string SceneId(const BaselineJob& job, SceneNames& names) {
  RunKeys keys = job.keys;
  keys["sequence"] = names.Of(job.images, keys.at("sequence"));
  return Json(keys).dump();
}

using JobsOfScenes = std::map<std::string, std::vector<const BaselineJob*>>;  // by SceneId

// Fills in the spread between all seeds of the baseline: at least that of one run that is off by
// one step of MetricEntry::Resolution.
void AddSpread(const std::vector<const BaselineJob*>& jobs, const std::string& metric,
               ScenePairs& scene) {
  std::map<std::uint64_t, double> by_seed;
  for (const BaselineJob* job : jobs) {
    const auto value = job->values.find(metric);
    if (value != job->values.end()) by_seed.emplace(job->seed, Scaled(metric, value->second));
  }
  std::vector<double> values;
  for (const auto& [seed, value] : by_seed) values.push_back(value);
  scene.known_seeds = values.size();
  if (values.size() < 2) return;
  const auto count = static_cast<double>(values.size());
  const double step = IsRelative(metric) ? kStep : FindEntry(metric)->Resolution(MeanOf(values));
  scene.variance = std::max(SquaresAroundMean(values) / (count - 1.0), step * step / count);
}

// Without scenes of one seed, whose spread is not known.
std::vector<ScenePairs> GatherScenes(const JobsOfScenes& jobs, SceneNames& names,
                                     const std::string& metric, const std::string& variant,
                                     const std::vector<RunPair>& pairs) {
  std::vector<ScenePairs> scenes;
  for (const RunPair& pair : pairs) {
    const BaselineJob& job = *pair.baseline;
    const auto now = pair.values.find(metric);
    const auto then = job.values.find(metric);
    if (job.keys.at("variant") != variant || now == pair.values.end() || then == job.values.end()) {
      continue;
    }
    ScenePairs fresh;
    fresh.id = SceneId(job, names);
    fresh.label = SceneLabel(job.keys);
    ScenePairs& scene = FindOrAdd(scenes, &ScenePairs::id, std::move(fresh));
    if (scene.label != SceneLabel(job.keys) &&
        std::count(scene.seeds.begin(), scene.seeds.end(), job.seed) > 0) {
      continue;  // the same scene under another name
    }
    scene.seeds.push_back(job.seed);
    scene.baseline.push_back(Scaled(metric, then->second));
    scene.now.push_back(Scaled(metric, now->second));
  }
  for (ScenePairs& scene : scenes) AddSpread(jobs.at(scene.id), metric, scene);
  std::erase_if(scenes, [](const ScenePairs& scene) { return scene.known_seeds < 2; });
  return scenes;
}

// What is compared at once: a metric of one variant on one or all of its scenes.
struct Candidate {
  Comparison comparison;
  std::vector<ScenePairs> scenes;
};

std::vector<Candidate> FindCandidates(const Baseline& baseline, const std::vector<RunPair>& pairs) {
  std::vector<std::string> variants;
  for (const RunPair& pair : pairs) AddOnce(pair.baseline->keys.at("variant"), variants);
  SceneNames names;
  JobsOfScenes jobs;
  for (const BaselineJob& job : baseline.jobs) jobs[SceneId(job, names)].push_back(&job);
  std::vector<Candidate> candidates;
  for (const std::string& variant : variants) {
    for (const BaselineMetric& metric : baseline.metrics) {
      const std::vector<ScenePairs> scenes = GatherScenes(jobs, names, metric.name, variant, pairs);
      if (scenes.empty()) continue;
      Comparison empty;
      empty.variant = variant;
      empty.metric = metric.name;
      empty.unit = NameOf(metric.unit);
      empty.relative = IsRelative(metric.name);
      candidates.push_back({empty, scenes});
      if (scenes.size() == 1) continue;
      for (const ScenePairs& scene : scenes) {
        candidates.push_back({empty, {scene}});
        candidates.back().comparison.scene = scene.label;
      }
    }
  }
  return candidates;
}

// The probability with which one of the candidates of its kind may raise a false alarm.
double TailOf(const Candidate& candidate, const std::vector<Candidate>& all) {
  const auto alike = std::count_if(all.begin(), all.end(), [&](const Candidate& other) {
    return other.comparison.scene.empty() == candidate.comparison.scene.empty();
  });
  return std::max(0.5 * kFalseAlarms / static_cast<double>(alike), 1e-9);
}

// A weighted mean over scenes, and the difference of two such means that is as rare as `tail`.
struct Weighed {
  double baseline = 0.0;
  double now = 0.0;
  double tolerance = 0.0;
};

// Scenes are weighted by their precision. The variance of each is estimated from few seeds, so it
// counts together with the mean variance of all, as if that were known from kSeedsOfAll of them.
// Twice the variance, because both the baseline and the checked runs are random draws. `seeds`: as
// if each scene had that many; 0: as many as it has.
Weighed Weigh(const std::vector<ScenePairs>& scenes, double tail, std::size_t seeds = 0) {
  constexpr double kSeedsOfAll = 4.0;
  double mean_variance = 0.0;
  for (const ScenePairs& scene : scenes) mean_variance += scene.variance;
  mean_variance /= static_cast<double>(scenes.size());
  Weighed weighed;
  double sum = 0.0;
  double variance = 0.0;
  double squares = 0.0;  // Welch and Satterthwaite's, for the degrees of freedom
  for (const ScenePairs& scene : scenes) {
    const double degrees = static_cast<double>(seeds > 0 ? seeds : scene.known_seeds) - 1.0;
    const double runs = static_cast<double>(seeds > 0 ? seeds : scene.now.size());
    const double weight =
        (degrees + kSeedsOfAll) / (degrees * scene.variance + kSeedsOfAll * mean_variance);
    const double part = weight * weight * 2.0 * scene.variance / runs;
    sum += weight;
    variance += part;
    squares += part * part / degrees;
    weighed.baseline += weight * MeanOf(scene.baseline);
    weighed.now += weight * MeanOf(scene.now);
  }
  weighed.baseline /= sum;
  weighed.now /= sum;
  const int degrees = std::max(1, static_cast<int>(variance * variance / squares));
  weighed.tolerance = StudentQuantile(tail, degrees) * std::sqrt(variance) / sum;
  return weighed;
}

// Whether the value could be worse by more than the tolerance.
bool CanFail(const Comparison& comparison) {
  if (comparison.relative) return comparison.tolerance < kMostTolerated;
  if (FindEntry(comparison.metric)->higher_is_better()) {
    return comparison.tolerance < comparison.baseline;
  }
  return comparison.tolerance < kMostTolerated * std::max(comparison.baseline, 1.0);
}

Comparison Judge(const Candidate& candidate, double tail) {
  Comparison comparison = candidate.comparison;
  const Weighed weighed = Weigh(candidate.scenes, tail);
  const bool relative = comparison.relative;
  comparison.baseline = relative ? std::exp(weighed.baseline) : weighed.baseline;
  comparison.now = relative ? std::exp(weighed.now) : weighed.now;
  comparison.tolerance = relative ? std::expm1(weighed.tolerance) : weighed.tolerance;
  bool same = true;
  for (const ScenePairs& scene : candidate.scenes) {
    comparison.pairs += scene.now.size();
    same = same && scene.now == scene.baseline;
  }
  const bool higher_is_better = FindEntry(comparison.metric)->higher_is_better();
  const double worse_by = (weighed.now - weighed.baseline) * (higher_is_better ? -1.0 : 1.0);
  comparison.verdict = !CanFail(comparison)            ? Verdict::kBlind
                       : same                          ? Verdict::kSame
                       : worse_by > weighed.tolerance  ? Verdict::kWorse
                       : worse_by < -weighed.tolerance ? Verdict::kBetter
                                                       : Verdict::kWithin;
  return comparison;
}

std::vector<RunPair> WithItself(const Baseline& baseline) {
  std::vector<RunPair> pairs;
  for (const BaselineJob& job : baseline.jobs) {
    if (std::count(baseline.seeds.begin(), baseline.seeds.end(), job.seed) == 0) continue;
    pairs.push_back({&job, job.values});
  }
  return pairs;
}

// The tolerance that a comparison must not exceed. Empty if there is none.
std::optional<double> MostTolerated(const Comparison& comparison) {
  const MetricId id = FindEntry(comparison.metric)->id;
  if (id == MetricId::kCameraAte) return std::log(2.0);
  const bool success = id == MetricId::kObjectSuccess5cm || id == MetricId::kObjectSuccess10cm ||
                       id == MetricId::kObjectSuccess20cm;
  constexpr double kLoss = 0.1;
  return success && comparison.baseline > kLoss ? std::optional(kLoss) : std::nullopt;
}

}  // namespace

std::vector<Comparison> CompareValues(const Baseline& baseline, const std::vector<RunPair>& pairs) {
  const std::vector<Candidate> candidates = FindCandidates(baseline, pairs);
  std::vector<Comparison> comparisons;
  for (const Candidate& candidate : candidates) {
    comparisons.push_back(Judge(candidate, TailOf(candidate, candidates)));
  }
  return comparisons;
}

std::vector<Comparison> NoticedBy(const Baseline& baseline) {
  std::vector<Comparison> noticed = CompareValues(baseline, WithItself(baseline));
  std::erase_if(noticed, [](const Comparison& comparison) { return !comparison.scene.empty(); });
  return noticed;
}

void CheckSensitivity(const Baseline& baseline, const std::string& where) {
  constexpr std::size_t kMostSeeds = 100;
  const std::vector<Candidate> candidates = FindCandidates(baseline, WithItself(baseline));
  std::size_t needed = 0;
  std::string missed;
  for (const Candidate& candidate : candidates) {
    if (!candidate.comparison.scene.empty()) continue;
    const double tail = TailOf(candidate, candidates);
    const Comparison comparison = Judge(candidate, tail);
    const std::optional<double> most = MostTolerated(comparison);
    if (!most || Weigh(candidate.scenes, tail).tolerance <= *most) continue;
    if (missed.empty()) {
      missed = StrCat(comparison.metric, " of ", comparison.variant, " that gets worse by ",
                      ToleranceText(comparison), " unnoticed on another platform");
    }
    std::size_t seeds = 2;
    while (seeds <= kMostSeeds && Weigh(candidate.scenes, tail, seeds).tolerance > *most) ++seeds;
    needed = std::max(needed, seeds);
  }
  if (missed.empty()) return;
  const std::string seeds = needed > kMostSeeds
                                ? ""
                                : StrCat(" (experiment run --seeds ", needed,
                                         ", check --gate-seeds ", needed, "; or more scenes)");
  ThrowError(where, missed,
             StrCat("less than a doubling of camera ATE and a loss of 0.1 success: ",
                    needed > kMostSeeds ? "more scenes" : StrCat(needed, " seeds"), seeds));
}

}  // namespace cvo::reports
