// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace cvo::reports {

// A mean is sum over weight: errors have weight 1, fractions that of what they are a fraction of.
struct Part {
  double sum = 0.0;
  double weight = 1.0;
};

// One number of one body, or of a whole scene, in one repetition, and its counterpart where two
// variants are compared.
struct Sample {
  std::string family;      // of scenes; empty: none
  std::string scene;       // one draw of the family
  std::string body;        // empty: the scene as a whole
  std::string repetition;  // seed and whatever else is averaged over
  Part value;
  Part reference = {};
};

// How bodies make the figure of their scene; that of the table is the mean over scenes.
enum class Within { kMean, kSum };

// What remains of a body or a scene when its repetitions are averaged.
struct Unit {
  std::array<Part, 2> parts;  // value, reference
};

// What is resampled: scenes within their families, each with the figure of all its bodies. Where
// all samples are of one scene there is only its bodies to resample, which says nothing of others.
struct Strata {
  std::vector<std::vector<Unit>> units;
  Within within = Within::kMean;  // how units make the figure of their stratum
  std::size_t scenes = 0;
  std::size_t bodies = 0;

  bool of_scenes() const { return scenes > 1; }
};

// Families by name, their scenes by name: the order of the samples does not matter. Empty where
// the weights of a scene add up to nothing. Throws Error for two samples of the same scene, body
// and repetition.
std::optional<Strata> GroupSamples(const std::vector<Sample>& samples, Within within);

// Value and reference: the mean over strata. Empty where there is none, or a stratum's weights add
// up to nothing.
std::optional<std::array<double, 2>> MeanOverStrata(const std::vector<std::vector<Unit>>& strata,
                                                    Within within);

}  // namespace cvo::reports
