// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/family/draws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"

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

}  // namespace cvo::synth
