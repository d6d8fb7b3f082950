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

// One number of one thing (a body, a scene) in one repetition, and its counterpart where two
// variants are compared.
struct Sample {
  std::string stratum;     // things are resampled within these: the scene of a body
  std::string unit;        // the thing
  std::string repetition;  // seed and whatever else is averaged over
  Part value;
  Part reference = {};
};

// How things make the figure of their stratum; that of the table is the mean over strata.
enum class Within { kMean, kSum };

// What remains of a thing when its repetitions are averaged.
struct Unit {
  std::array<Part, 2> parts;  // value, reference
};

// Strata by name, their units by name: the order of the samples does not matter. Throws Error for
// two samples of the same stratum, unit and repetition.
std::vector<std::vector<Unit>> AverageRepetitions(const std::vector<Sample>& samples);

// Value and reference. Empty where a stratum's weights add up to nothing, or there is no stratum.
std::optional<std::array<double, 2>> MeanOverStrata(const std::vector<std::vector<Unit>>& strata,
                                                    Within within);

}  // namespace cvo::reports
