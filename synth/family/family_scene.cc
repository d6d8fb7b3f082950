// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "synth/family/generate.h"

namespace cvo::synth {
namespace {

constexpr char kSeedMark = '@';
constexpr std::string_view kKnob = "knob.";

}  // namespace

std::uint32_t ParseFamilySeed(const std::string& text) {
  const auto seed = ParseInteger(text);
  if (!seed || *seed < 0 || *seed > std::numeric_limits<std::uint32_t>::max()) {
    ThrowError("seed", Quoted(text), "an integer from 0 to 4294967295");
  }
  return static_cast<std::uint32_t>(*seed);
}

std::string FamilyScene::Name() const {
  std::string name = StrCat(family, kSeedMark, seed);
  for (const std::string& assignment : set) name += "," + assignment;
  return name;
}

bool IsFamilyScene(const std::string& scene) {
  return scene.find(kSeedMark) != std::string::npos && !std::filesystem::exists(scene);
}

FamilyScene ParseFamilyScene(const std::string& scene) {
  FamilyScene parsed;
  const std::size_t mark = scene.rfind(kSeedMark);
  Require(mark != std::string::npos, "the name of a family's scene has a seed");
  parsed.family = scene.substr(0, mark);
  std::size_t start = mark + 1;
  std::size_t end = std::min(scene.find(',', start), scene.size());
  parsed.seed = ParseFamilySeed(scene.substr(start, end - start));
  while (end < scene.size()) {
    start = end + 1;
    end = std::min(scene.find(',', start), scene.size());
    parsed.set.push_back(scene.substr(start, end - start));
  }
  return parsed;
}

SceneDescription LoadScene(const std::string& scene, const std::vector<std::string>& assignments) {
  if (!IsFamilyScene(scene)) return SceneDescription::Load(scene, assignments);
  FamilyScene parsed = ParseFamilyScene(scene);
  std::vector<std::string> others;
  for (const std::string& assignment : assignments) {
    if (assignment.starts_with(kKnob)) {
      parsed.set.push_back(assignment.substr(kKnob.size()));
    } else {
      others.push_back(assignment);
    }
  }
  const Json json = GenerateScene(LoadFamily(parsed.family), parsed.seed, parsed.set);
  return SceneDescription::Parse(json, "scene " + scene, others);
}

}  // namespace cvo::synth
