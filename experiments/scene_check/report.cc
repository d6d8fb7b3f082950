// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/scene_check/report.h"

#include <algorithm>
#include <cmath>

namespace cvo {

bool SceneCheck::Passed() const {
  switch (bound) {
    case Bound::kAtMost:
      return figure <= limit;
    case Bound::kAtLeast:
      return figure >= limit;
    case Bound::kNone:
      break;
  }
  return true;
}

bool SceneCheckReport::Passed() const {
  return std::all_of(checks.begin(), checks.end(),
                     [](const SceneCheck& check) { return check.Passed(); });
}

Json SceneCheckJson(const SceneCheckReport& report) {
  Json checks = Json::array();
  for (const SceneCheck& check : report.checks) {
    Json row = {{"name", check.name},
                {"figure", std::isfinite(check.figure) ? Json(check.figure) : Json(nullptr)},
                {"unit", check.unit}};
    if (check.bound != Bound::kNone) {
      row[check.bound == Bound::kAtMost ? "at_most" : "at_least"] = check.limit;
      row["passed"] = check.Passed();
    }
    if (!check.where.empty()) row["worst"] = check.where;
    checks.push_back(std::move(row));
  }
  return {{"schema_version", 1},       {"folder", report.folder},
          {"frames", report.frames},   {"image_frames", report.image_frames},
          {"passed", report.Passed()}, {"checks", checks}};
}

}  // namespace cvo
