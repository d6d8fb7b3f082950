// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/drawn_scenes.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo::reports {

std::vector<DrawnScene> GroupByScene(const std::vector<DrawnRun>& runs) {
  std::vector<DrawnScene> scenes;
  for (const DrawnRun& run : runs) {
    auto found = std::find_if(scenes.begin(), scenes.end(), [&](const DrawnScene& scene) {
      return scene.sequence == run.sequence;
    });
    if (found == scenes.end()) found = scenes.insert(scenes.end(), {run.sequence, {}});
    found->runs.push_back(&run);
  }
  return scenes;
}

std::vector<std::string> VariantsOf(const std::vector<DrawnRun>& runs) {
  std::vector<std::string> variants;
  for (const DrawnRun& run : runs) {
    if (std::find(variants.begin(), variants.end(), run.variant) == variants.end()) {
      variants.push_back(run.variant);
    }
  }
  return variants;
}

std::string SeedText(const DrawnScene& scene) {
  std::string each;
  bool same = true;
  for (const DrawnRun* run : scene.runs) {
    same = same && run->seed == scene.runs.front()->seed;
    each += StrCat(each.empty() ? "" : ", ", run->variant, " ", run->seed);
  }
  return same ? StrCat("seed ", scene.runs.front()->seed) : "seeds: " + each;
}

}  // namespace cvo::reports
