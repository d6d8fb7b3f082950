// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/family/family.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "synth/scene/object_reader.h"

namespace cvo::synth {
namespace {

constexpr std::array<const char*, 4> kKinds = {"uniform", "integer", "choose", "knob"};

bool IsDraw(const Json& value) {
  return value.is_object() && value.size() == 1 &&
         std::find(kKinds.begin(), kKinds.end(), value.begin().key()) != kKinds.end();
}

const Knob& FindKnob(const std::vector<Knob>& knobs, const std::string& name,
                     const std::string& where) {
  if (const Knob* knob = FindBy(knobs, &Knob::name, name)) return *knob;
  std::vector<std::string> names;
  for (const Knob& knob : knobs) names.push_back(knob.name);
  ThrowError(where, "no knob " + Quoted(name), OneOfKnown(name, names));
}

void CheckRange(const Json& range, bool integers, const std::string& where) {
  const auto is_end = [&](const Json& end) {
    return integers ? end.is_number_integer() : end.is_number();
  };
  if (!range.is_array() || range.size() != 2 || !is_end(range[0]) || !is_end(range[1])) {
    ThrowError(where, range.dump(), integers ? "two integers" : "two numbers");
  }
  if (range[1].get<double>() < range[0].get<double>()) {
    ThrowError(where, "the empty range " + range.dump(), "a range from low to high");
  }
}

void CheckParts(const Json& value, const std::string& where, const std::vector<Knob>& knobs) {
  for (const auto& [key, part] : value.items()) CheckDraws(part, StrCat(where, ".", key), knobs);
}

double Rounded(double value, double steps) { return std::round(value * steps) / steps + 0.0; }

bool Allows(const Knob& knob, const Json& value) {
  const bool range = knob.may.size() == 2 && knob.may[0].is_number() && knob.may[1].is_number();
  if (!range) return std::find(knob.may.begin(), knob.may.end(), value) != knob.may.end();
  const bool whole = knob.may[0].is_number_integer() && knob.may[1].is_number_integer();
  if (!value.is_number() || (whole && !value.is_number_integer())) return false;
  return value.get<double>() >= knob.may[0].get<double>() &&
         value.get<double>() <= knob.may[1].get<double>();
}

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

constexpr char kSeedMark = '@';
constexpr std::string_view kKnob = "knob.";

}  // namespace

void CheckDraws(const Json& value, const std::string& where, const std::vector<Knob>& knobs) {
  if (!IsDraw(value)) {
    if (value.is_structured()) CheckParts(value, where, knobs);
    return;
  }
  const std::string kind = value.begin().key();
  const Json& from = value.begin().value();
  const std::string at = StrCat(where, ".", kind);
  if (kind == "uniform" || kind == "integer") {
    CheckRange(from, kind == "integer", at);
  } else if (kind == "choose") {
    if (!from.is_array() || from.empty()) ThrowError(at, from.dump(), "a list of values");
    CheckParts(from, at, knobs);
  } else {
    if (!from.is_string()) ThrowError(at, from.dump(), "the name of a knob");
    FindKnob(knobs, from, at);
  }
}

Draws::Draws(std::string family, std::uint32_t seed, const std::vector<Knob>& knobs,
             const std::vector<std::string>& set)
    : family_(std::move(family)), seed_(seed), knobs_(knobs) {
  for (const std::string& assignment : set) Fix(assignment);
}

void Draws::Fix(const std::string& assignment) {
  const std::string where = "--set " + assignment;
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string::npos) {
    ThrowError(where, "no KNOB=VALUE", "KNOB=VALUE, for example movers=3");
  }
  const Knob& knob = FindKnob(knobs_, assignment.substr(0, equals), where);
  const std::string text = assignment.substr(equals + 1);
  Json value = Json::parse(text, nullptr, false);
  if (value.is_discarded()) value = text;  // a word needs no quotes
  if (!Allows(knob, value)) {
    const bool range = knob.may.size() == 2 && knob.may[0].is_number();
    ThrowError(where, Quoted(text), (range ? "a value in " : "one of ") + Json(knob.may).dump());
  }
  fixed_[knob.name] = std::move(value);
}

Json Draws::TakeKnob(const std::string& name, const std::string& stream) const {
  const auto fixed = fixed_.find(name);
  if (fixed != fixed_.end()) return fixed->second;
  const Knob& knob = FindKnob(knobs_, name, stream);
  return Take(knob.draw, knob.per_body ? stream + "/knob " + name : "knob " + name);
}

Json Draws::TakeDraw(const std::string& kind, const Json& from, const std::string& stream) const {
  if (kind == "knob") return TakeKnob(from, stream);
  Rng rng = Stream(stream);
  if (kind == "uniform") return Rounded(rng.Uniform(from[0], from[1]), 1e4);
  if (kind == "integer") {
    const auto low = from[0].get<std::int64_t>();
    const auto count = static_cast<std::uint64_t>(from[1].get<std::int64_t>() - low) + 1;
    return low + static_cast<std::int64_t>(rng.UniformInt(count));
  }
  return Take(from[rng.UniformInt(from.size())], stream + "/chosen");
}

Json Draws::Take(const Json& value, const std::string& stream) const {
  if (IsDraw(value)) return TakeDraw(value.begin().key(), value.begin().value(), stream);
  if (!value.is_structured()) return value;
  Json taken = value;
  for (auto& [key, part] : taken.items()) part = Take(part, stream + "." + key);
  return taken;
}

double Millis(double value) { return Rounded(value, 1e3); }

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
