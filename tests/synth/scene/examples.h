// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/files/json/json.h"
#include "synth/scene/description.h"

namespace cvo::test {

// A valid scene without objects, for tests to modify. The camera moves along x and looks along its
// route.
inline Json EmptyScene() {
  return ParseJson(R"({
    "name": "empty", "rig": {"width_px": 640, "height_px": 480, "focal_px": 450, "baseline_m": 0.12},
    "frames": 30, "rate_hz": 30,
    "room": {"size_m": [8, 8, 2.6], "shelves": 0, "tables": 0, "crates": 0, "posters": 0},
    "camera": {"route": {"points": [[-3, 0], [3, 0]], "speed_mps": 0.5}, "height_m": 1.2,
               "look_along": {}},
    "objects": []
  })",
                   "EmptyScene");
}

inline Json Ball(const std::string& name, const std::string& path) {
  return {{"name", name}, {"model", "ball"}, {"size_m", 0.5}, {"path", ParseJson(path, name)}};
}

}  // namespace cvo::test
