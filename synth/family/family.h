// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "synth/family/draws.h"

namespace cvo::synth {

// A distribution over scene files, described by a file of synth/families (synth/README.md).
struct Family {
  std::string where;  // names the family in errors
  std::string name;
  std::string about;
  std::vector<Knob> knobs;
  Json scene;   // a scene file with draws, without name, seeds, camera and objects
  Json layout;  // how camera and bodies are placed, with draws
};

// Loads a shipped family by name or a JSON file by path. Throws Error naming file and key.
Family LoadFamily(const std::string& family);
Family ParseFamily(const Json& json, const std::string& where);

struct ShippedFamily {
  std::string name;  // the `name` in `text`
  std::string text;  // JSON
};
// Returns the files of synth/families, which are compiled in.
std::vector<ShippedFamily> ShippedFamilies();

// What a seed may be used for: options are chosen on development seeds (0 to 999), results are
// reported on test seeds (1000 to 1999).
enum class Split { kDevelopment, kTest, kNone };
Split SplitOf(std::uint32_t seed);
const char* SplitName(Split split);

}  // namespace cvo::synth
