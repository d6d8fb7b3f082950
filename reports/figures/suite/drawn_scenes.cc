// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite/drawn_scenes.h"

#include "core/base/error.h"
#include "core/base/lists.h"

namespace cvo::reports {

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
  std::string each;
  bool same = true;
  for (const DrawnRun* run : scene.runs) {
    same = same && run->seed == scene.runs.front()->seed;
    each += StrCat(each.empty() ? "" : ", ", run->variant, " ", run->seed);
  }
  return same ? StrCat("seed ", scene.runs.front()->seed) : "seeds: " + each;
}

}  // namespace cvo::reports
