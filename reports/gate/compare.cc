// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/compare.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/results/metric_catalogue.h"

namespace cvo::reports {
namespace {

using Keys = std::map<std::string, std::string>;

// One metric over the pairs of one variant on one scene.
struct ScenePairs {
  Keys keys;
  SceneDifferences differences;  // positive is worse
  double baseline = 0.0;         // means over the pairs
  double now = 0.0;
};

// A comparison whose tolerance is not known until all comparisons have been counted.
struct Candidate {
  Comparison comparison;
  std::vector<ScenePairs> scenes;
};

// Returns the keys that distinguish the scenes of this baseline.
std::vector<std::string> SceneKeys(const Baseline& baseline) {
  std::vector<std::string> names = {"sequence"};
  const Keys& first = baseline.jobs.front().keys;
  for (const BaselineJob& job : baseline.jobs) {
    for (const auto& [key, value] : job.keys) {
      const auto found = first.find(key);
      const bool known = std::find(names.begin(), names.end(), key) != names.end();
      if (key == "variant" || known || (found != first.end() && found->second == value)) continue;
      names.push_back(key);
    }
  }
  return names;
}

std::string SceneLabel(const Keys& keys, const std::vector<std::string>& scene_keys) {
  std::string label = keys.at("sequence");
  for (const std::string& key : scene_keys) {
    const auto value = keys.find(key);
    if (key == "sequence") continue;
    label += StrCat(" ", key, "=", value == keys.end() ? "default" : value->second);
  }
  return label;
}

ScenePairs& SceneOf(const Keys& keys, std::vector<ScenePairs>& scenes) {
  return FindOrAdd(scenes, &ScenePairs::keys, {keys, {}, 0.0, 0.0});
}

std::vector<ScenePairs> GatherScenes(const Baseline& baseline, const BaselineMetric& metric,
                                     const std::string& variant,
                                     const std::vector<RunPair>& pairs) {
  const double sign = FindEntry(metric.name)->higher_is_better() ? -1.0 : 1.0;
  std::vector<ScenePairs> scenes;
  for (const RunPair& pair : pairs) {
    const auto now = pair.values.find(metric.name);
    const auto then = pair.baseline->values.find(metric.name);
    if (pair.baseline->keys.at("variant") != variant || now == pair.values.end() ||
        then == pair.baseline->values.end()) {
      continue;
    }
    ScenePairs& scene = SceneOf(pair.baseline->keys, scenes);
    scene.differences.worse_by.push_back(sign * (now->second - then->second));
    scene.baseline += then->second;
    scene.now += now->second;
  }
  for (ScenePairs& scene : scenes) {
    const double count = static_cast<double>(scene.differences.worse_by.size());
    scene.baseline /= count;
    scene.now /= count;
    const auto spread = SpreadOfSeeds(baseline, metric, scene.keys);
    if (spread) scene.differences.seed_variance = spread->variance;
    if (spread) scene.differences.seed_degrees = spread->degrees;
  }
  std::erase_if(scenes, [](const ScenePairs& s) { return s.differences.seed_degrees == 0; });
  return scenes;
}

Candidate MakeCandidate(Comparison comparison, std::vector<ScenePairs> scenes) {
  for (const ScenePairs& scene : scenes) {
    comparison.baseline += scene.baseline / static_cast<double>(scenes.size());
    comparison.now += scene.now / static_cast<double>(scenes.size());
    comparison.pairs += scene.differences.worse_by.size();
  }
  return {std::move(comparison), std::move(scenes)};
}

void Judge(std::size_t comparisons, Candidate& candidate) {
  std::vector<SceneDifferences> scenes;
  bool same = true;
  for (const ScenePairs& scene : candidate.scenes) {
    scenes.push_back(scene.differences);
    for (const double worse_by : scene.differences.worse_by) same = same && worse_by == 0.0;
  }
  Comparison& comparison = candidate.comparison;
  comparison.tolerance = Tolerance(scenes, comparisons);
  const double worse_by = MeanDifference(scenes);
  comparison.verdict = same                               ? Verdict::kSame
                       : worse_by > comparison.tolerance  ? Verdict::kWorse
                       : worse_by < -comparison.tolerance ? Verdict::kBetter
                                                          : Verdict::kWithin;
}

std::vector<std::string> Variants(const std::vector<RunPair>& pairs) {
  std::vector<std::string> variants;
  for (const RunPair& pair : pairs) AddOnce(pair.baseline->keys.at("variant"), variants);
  return variants;
}

}  // namespace

std::vector<Comparison> CompareValues(const Baseline& baseline, const std::vector<RunPair>& pairs) {
  const std::vector<std::string> scene_keys = SceneKeys(baseline);
  std::vector<Candidate> candidates;
  for (const std::string& variant : Variants(pairs)) {
    for (const BaselineMetric& metric : baseline.metrics) {
      const std::vector<ScenePairs> scenes = GatherScenes(baseline, metric, variant, pairs);
      if (scenes.empty()) continue;
      Comparison comparison;
      comparison.variant = variant;
      comparison.metric = metric.name;
      comparison.unit = NameOf(metric.unit);
      candidates.push_back(MakeCandidate(comparison, scenes));
      if (scenes.size() == 1) continue;
      for (const ScenePairs& scene : scenes) {
        comparison.scene = SceneLabel(scene.keys, scene_keys);
        candidates.push_back(MakeCandidate(comparison, {scene}));
      }
    }
  }
  std::vector<Comparison> comparisons;
  for (Candidate& candidate : candidates) {
    Judge(candidates.size(), candidate);
    comparisons.push_back(candidate.comparison);
  }
  return comparisons;
}

}  // namespace cvo::reports
