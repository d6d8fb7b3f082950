// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/family/family.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "synth/scene/object_reader.h"

namespace cvo::synth {
namespace {

Knob ParseKnob(const std::string& name, ObjectReader reader) {
  Knob knob;
  knob.name = name;
  knob.about = reader.Text("about");
  knob.unit = reader.TextOr("unit", "");
  knob.draw = reader.Value("draw");
  const Json& may = reader.Value("may");
  if (!may.is_array() || may.empty()) {
    ThrowError(reader.Where("may"), may.dump(), "two numbers or a list of values");
  }
  knob.may = {may.begin(), may.end()};
  knob.per_body = reader.BoolOr("per_body", false);
  reader.Finish();
  return knob;
}

}  // namespace

Family ParseFamily(const Json& json, const std::string& where) {
  ObjectReader reader(json, where, "");
  Family family;
  family.where = where;
  family.name = reader.Text("name");
  family.about = reader.Text("about");
  ObjectReader knobs = reader.Object("knobs");
  for (const auto& [name, knob] : reader.Value("knobs").items()) {
    family.knobs.push_back(ParseKnob(name, knobs.Object(name)));
  }
  reader.Object("scene");  // throws if it is not an object
  family.scene = reader.Value("scene");
  reader.Object("layout");
  family.layout = reader.Value("layout");
  reader.Finish();
  for (const Knob& knob : family.knobs) {
    // No knobs are allowed here: a knob drawn from another could be drawn from itself.
    CheckDraws(knob.draw, StrCat(where, ", knobs.", knob.name, ".draw"), {});
  }
  CheckDraws(family.scene, where + ", scene", family.knobs);
  CheckDraws(family.layout, where + ", layout", family.knobs);
  return family;
}

Family LoadFamily(const std::string& family) {
  std::vector<std::string> names;
  for (const ShippedFamily& shipped : ShippedFamilies()) {
    if (shipped.name == family) {
      return ParseFamily(ParseJson(shipped.text, "family " + family), "family " + family);
    }
    names.push_back(shipped.name);
  }
  if (std::filesystem::is_regular_file(family)) return ParseFamily(ReadJson(family), family);
  ThrowError("family " + Quoted(family), "neither a shipped family nor a file",
             "a JSON file or " + OneOfKnown(family, names));
}

Split SplitOf(std::uint32_t seed) {
  constexpr std::uint32_t kFirstTest = 1000;
  constexpr std::uint32_t kEndTest = 2000;
  if (seed < kFirstTest) return Split::kDevelopment;
  return seed < kEndTest ? Split::kTest : Split::kNone;
}

const char* SplitName(Split split) {
  if (split == Split::kDevelopment) return "development";
  return split == Split::kTest ? "test" : "none";
}

}  // namespace cvo::synth
