// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"

namespace cvo {

enum class Bound { kAtMost, kAtLeast, kNone };  // kNone: for information, always passes

// One figure of a rendered scene against its limit. A figure without data (no targets, no flow)
// is not in the list at all, or fails where the data must be there.
struct SceneCheck {
  std::string name;   // "disparity_offset_x"
  double figure = 0;  // NaN, where nothing could be measured, fails
  std::string unit;
  Bound bound = Bound::kAtMost;
  double limit = 0.0;
  std::string where;  // the worst place; empty where there is none

  bool Passed() const;
};

struct SceneCheckReport {
  std::string folder;
  int frames = 0;        // of the sequence
  int image_frames = 0;  // whose images were compared: an even choice of them
  std::vector<SceneCheck> checks;

  bool Passed() const;
};

// Figures that are not finite become null.
Json SceneCheckJson(const SceneCheckReport& report);

}  // namespace cvo
