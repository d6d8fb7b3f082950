// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::synth {

struct ShippedScene {
  std::string name;  // as in its text
  std::string text;  // JSON
};

// The scene files of synth/scenes, compiled in, so that the program finds them wherever it is.
std::vector<ShippedScene> ShippedScenes();

}  // namespace cvo::synth
