// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"

namespace cvo {

enum class Bound { kAtMost, kAtLeast, kNone };  // kNone: for information, always passes

// A measured figure of a rendered scene and its limit. A figure without data (no targets, no flow)
// is omitted, or fails if the data is mandatory.
struct SceneCheck {
  std::string name;   // "disparity_offset_x"
  double figure = 0;  // NaN, which fails, if nothing could be measured
  std::string unit;
  Bound bound = Bound::kAtMost;
  double limit = 0.0;
  std::string where;  // where the figure is worst; may be empty

  bool Passed() const;
};

struct SceneCheckReport {
  std::string folder;
  int frames = 0;        // of the sequence
  int image_frames = 0;  // evenly chosen frames whose images were compared
  std::vector<SceneCheck> checks;

  bool Passed() const;
};

// Returns the report as JSON. Figures that are not finite become null.
Json SceneCheckJson(const SceneCheckReport& report);

}  // namespace cvo
