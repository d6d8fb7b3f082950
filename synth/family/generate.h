// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synth/family/family.h"
#include "synth/scene/description.h"

namespace cvo::synth {

// The scene file of one seed. `set`: "KNOB=VALUE". The same seed and values give the same bytes on
// every machine. Throws Error naming the key for what the family file has wrong, and where no place
// is found for a body.
Json GenerateScene(const Family& family, std::uint32_t seed, const std::vector<std::string>& set);

// "17": throws Error outside 0 ... 2^32 - 1.
std::uint32_t ParseFamilySeed(const std::string& text);

// A scene of a family by name: "room@17" or "room@17,movers=3,speed_mps=0.5".
struct FamilyScene {
  std::string family;
  std::uint32_t seed = 0;
  std::vector<std::string> set;

  std::string Name() const;
};
bool IsFamilyScene(const std::string& scene);
FamilyScene ParseFamilyScene(const std::string& scene);

// A shipped scene, a scene file or a scene of a family. An assignment "knob.NAME=VALUE" fixes a
// knob of the family, others change values of the scene file.
SceneDescription LoadScene(const std::string& scene, const std::vector<std::string>& assignments);

}  // namespace cvo::synth
