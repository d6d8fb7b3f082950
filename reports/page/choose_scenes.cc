// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/choose_scenes.h"

#include <algorithm>
#include <map>
#include <optional>

#include "reports/tables/body_metrics.h"

namespace cvo::reports {
namespace {

// Everything that identifies a run, except the seed.
using Keys = std::map<std::string, std::string>;

std::vector<std::size_t> FirstSeeds(const std::vector<PageRun>& runs) {
  std::map<Keys, std::size_t> first;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SuiteRun& run = runs[i].run;
    if (!run.run || run.planned.system) continue;
    const auto [entry, added] = first.try_emplace(run.planned.keys, i);
    if (!added && run.planned.seed < runs[entry->second].run.planned.seed) entry->second = i;
  }
  std::vector<std::size_t> chosen;
  for (const auto& [keys, run] : first) chosen.push_back(run);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

// The priority of showing the images of a run; lower comes first.
int Rank(const PageRun& run, const std::string& reference) {
  const std::string variant = KeyOf(run.run.planned, "variant");
  if (variant == "full") return 0;
  return variant == reference || "variant=" + variant == reference ? 1 : 2;
}

// The share of frames of moving bodies that the run estimates within 10 cm; 1 if it has no moving
// body.
double SuccessOf(const PageRun& run) {
  const BodyMetric success = *FindBodyMetric("object_success_10cm");
  Part total = {0.0, 0.0};
  if (!run.run.run->bodies) return 1.0;
  for (const BodyRow& body : run.run.run->bodies->refined) {
    const std::optional<Part> part = PartOf(success, body);
    if (!part) continue;
    total.sum += part->sum;
    total.weight += part->weight;
  }
  return total.weight > 0.0 ? total.sum / total.weight : 1.0;
}

}  // namespace

SceneChoice ChooseScenes(const std::vector<PageRun>& runs, const std::string& reference,
                         std::size_t most) {
  std::vector<std::size_t> candidates = FirstSeeds(runs);
  if (candidates.size() > most) {
    std::stable_sort(candidates.begin(), candidates.end(), [&](std::size_t a, std::size_t b) {
      return SuccessOf(runs[a]) < SuccessOf(runs[b]);
    });
  }
  std::map<std::string, std::size_t> with_images;  // by sequence
  for (const std::size_t i : candidates) {
    const auto [entry, added] = with_images.try_emplace(KeyOf(runs[i].run.planned, "sequence"), i);
    if (!added && Rank(runs[i], reference) < Rank(runs[entry->second], reference)) {
      entry->second = i;
    }
  }
  SceneChoice choice;
  for (const bool images : {true, false}) {
    for (const std::size_t i : candidates) {
      const bool has_images = with_images[KeyOf(runs[i].run.planned, "sequence")] == i;
      if (has_images != images) continue;
      if (choice.scenes.size() < most) {
        choice.scenes.emplace_back(i, has_images);
      } else {
        ++choice.left_out;
      }
    }
  }
  return choice;
}

}  // namespace cvo::reports
