// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::synth {

struct ShippedScene {
  std::string name;  // the `name` in `text`
  std::string text;  // JSON
};

// Returns the scene files of synth/scenes. They are compiled in, so that the program does not
// depend on its location.
std::vector<ShippedScene> ShippedScenes();

}  // namespace cvo::synth
