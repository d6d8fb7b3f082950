// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace cvo::reports {

// The contribution to a mean, which is the sum divided by the weight. Errors have weight 1;
// fractions have the weight of what they are a fraction of.
struct Part {
  double sum = 0.0;
  double weight = 1.0;
};

// One number of one body, or of a whole scene, in one repetition, with its counterpart if two
// variants are compared.
struct Sample {
  std::string family;      // family of scenes; empty: none
  std::string scene;       // one draw from the family
  std::string body;        // empty: the scene as a whole
  std::string repetition;  // seed and everything else that is averaged over
  Part value;
  Part reference = {};
};

// How the figure of a scene is computed from its bodies. The figure of the table is the mean over
// scenes.
enum class Within { kMean, kSum };

// A body or a scene after averaging over its repetitions.
struct Unit {
  std::array<Part, 2> parts;  // value, reference
};

// What is resampled: scenes within their families, each with the figure of all its bodies. If all
// samples are of one scene, its bodies are resampled instead, which says nothing about other
// scenes.
struct Strata {
  std::vector<std::vector<Unit>> units;
  Within within = Within::kMean;  // how the figure of a stratum is computed from its units
  std::size_t scenes = 0;
  std::size_t bodies = 0;

  bool of_scenes() const { return scenes > 1; }
};

// Groups samples into strata. Families, and scenes within a family, are ordered by name, so the
// order of the samples does not matter. Empty if there are no samples, or the weights of a scene
// sum to 0. Throws Error if there are two samples of the same scene, body and repetition.
std::optional<Strata> GroupSamples(const std::vector<Sample>& samples, Within within);

// The mean over strata, of the value and of the reference. Empty if there are no strata, or the
// weights of a stratum sum to 0.
std::optional<std::array<double, 2>> MeanOverStrata(const std::vector<std::vector<Unit>>& strata,
                                                    Within within);

}  // namespace cvo::reports
