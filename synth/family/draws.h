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

// A number or choice of a family that a user may fix.
struct Knob {
  std::string name;
  std::string about;
  std::string unit;
  Json draw;              // what it is drawn from
  std::vector<Json> may;  // two numbers: the range of a fixed value; else the values it may have
  bool per_body = false;  // drawn for each body; else once for a scene
};

// In place of a value a family file may have a draw: {"uniform": [a, b]}, {"integer": [a, b]} (both
// ends included), {"choose": [value, ...]} or {"knob": name}. Throws Error naming the key of an
// empty range or list and of a knob that does not exist, anywhere in `value`.
void CheckDraws(const Json& value, const std::string& where, const std::vector<Knob>& knobs);

// Replaces draws by values. Each place has a random stream of its own, so that fixing one knob
// leaves all other draws as they are. Numbers are rounded to 0.0001.
class Draws {
 public:
  // `set`: "NAME=VALUE". Throws Error for a knob that does not exist and a value it cannot have.
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

// To 0.001, the last digit that a generated scene has: libraries' sines may differ beyond it.
double Millis(double value);

}  // namespace cvo::synth
