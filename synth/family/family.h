// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "synth/family/draws.h"

namespace cvo::synth {

// A distribution over scene files, as a file of synth/families describes it (synth/README.md).
struct Family {
  std::string where;  // names it in errors
  std::string name;
  std::string about;
  std::vector<Knob> knobs;
  Json scene;   // a scene file with draws in it, without name, seeds, camera and objects
  Json layout;  // how camera and bodies are placed, with draws in it
};

// A shipped family's name or the path of a JSON file. Throws Error naming file and key.
Family LoadFamily(const std::string& family);
Family ParseFamily(const Json& json, const std::string& where);

struct ShippedFamily {
  std::string name;  // as in its text
  std::string text;  // JSON
};
// The files of synth/families, compiled in.
std::vector<ShippedFamily> ShippedFamilies();

// What a seed may be used for: options are chosen on development seeds (0 to 999), results are
// reported on test seeds (1000 to 1999).
enum class Split { kDevelopment, kTest, kNone };
Split SplitOf(std::uint32_t seed);
const char* SplitName(Split split);

}  // namespace cvo::synth
