// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/files/json/json.h"

namespace cvo::synth {

// A parameter of a family that the user may fix.
struct Knob {
  std::string name;
  std::string about;
  std::string unit;
  Json draw;              // distribution of its values, see CheckDraws
  std::vector<Json> may;  // values the user may fix: a range if two numbers, otherwise a list
  bool per_body = false;  // drawn for each body; otherwise once per scene
};

// Any value in a family file can be replaced by a draw: {"uniform": [a, b]}, {"integer": [a, b]}
// (both ends included), {"choose": [value, ...]} or {"knob": name}. Checks all draws within
// `value`. Throws Error naming the key for an empty range or list and for an unknown knob.
void CheckDraws(const Json& value, const std::string& where, const std::vector<Knob>& knobs);

// Replaces draws by values. Every draw has its own random stream, so that fixing one knob leaves
// all other draws unchanged. Uniform draws are rounded to 0.0001.
class Draws {
 public:
  // `set` holds assignments "NAME=VALUE". Throws Error for an unknown knob and for a value that it
  // does not allow.
  Draws(std::string family, std::uint32_t seed, const std::vector<Knob>& knobs,
        const std::vector<std::string>& set);

  Json Take(const Json& value, const std::string& stream) const;
  Rng Stream(const std::string& stream) const {
    return Rng(seed_, "family/" + family_ + "/" + stream);
  }

 private:
  void Fix(const std::string& assignment);
  Json TakeKnob(const std::string& name, const std::string& stream) const;
  Json TakeDraw(const std::string& kind, const Json& from, const std::string& stream) const;

  std::string family_;
  std::uint32_t seed_;
  const std::vector<Knob>& knobs_;
  std::map<std::string, Json> fixed_;
};

// Rounds to 0.001, as all computed values of a generated scene are: beyond that, the sine and
// cosine of different libraries may differ.
double Millis(double value);

}  // namespace cvo::synth
