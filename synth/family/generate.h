// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synth/family/family.h"
#include "synth/scene/description.h"

namespace cvo::synth {

// Generates the scene file of a seed. `set` holds assignments "KNOB=VALUE". The same seed and
// assignments give the same bytes on every machine. Throws Error naming the key for a mistake in
// the family file, and if no place is found for a body.
Json GenerateScene(const Family& family, std::uint32_t seed, const std::vector<std::string>& set);

// Parses a seed, "17". Throws Error unless it is an integer from 0 to 2^32 - 1.
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

// Loads a shipped scene, a scene file or a scene of a family. An assignment "knob.NAME=VALUE" fixes
// a knob of the family; all others change values of the scene file.
SceneDescription LoadScene(const std::string& scene, const std::vector<std::string>& assignments);

}  // namespace cvo::synth
