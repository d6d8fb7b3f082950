// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json_record.h"

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

inline constexpr double kConfidence = 0.95;

struct Interval {
  double low = 0.0;
  double high = 0.0;

  bool Contains(double value) const { return low <= value && value <= high; }
  CVO_FIELDS(low, high);
};

// The minimum number of pairs of a significant difference. With fewer, not even differences of one
// sign would be unlikely enough by chance (two-sided sign test: 2 * 0.5^5 > 0.05), whatever the
// interval says.
inline constexpr std::size_t kMinPairs = 6;

struct Estimate {
  double value = 0.0;
  std::optional<Interval> interval;  // empty if nothing can be resampled
  std::size_t scenes = 0;
  std::size_t bodies = 0;
};

// The mean over scenes with its bootstrap interval: scenes are resampled within their families,
// each with the figure of all its bodies; the bodies if there is one scene, which says nothing
// about others. The order of the samples does not matter. Empty if there are no samples, or the
// weights of a scene sum to 0. Throws Error if there are two samples of one scene, body and
// repetition.
std::optional<Estimate> EstimateMean(const std::vector<Sample>& samples, Within within);

// A value compared with its reference on the same scenes, bodies and repetitions.
struct PairedEstimate {
  double value = 0.0;
  double reference_value = 0.0;
  double difference = 0.0;  // value - reference_value
  std::optional<Interval> interval;
  // The difference in percent of the reference; empty if that is not positive.
  std::optional<double> percent;
  std::optional<double> p_value;  // of no difference, uncorrected (PairedPValue)
  std::size_t pairs = 0;          // units resampled: scenes, or bodies of the only scene
};

std::optional<PairedEstimate> EstimateDifference(const std::vector<Sample>& pairs, Within within);

// Differences of pairs, grouped by stratum.
using Differences = std::vector<std::vector<double>>;

// Two-sided p-value of the hypothesis "the mean over strata of their mean differences is 0".
// Student's t, with as many degrees of freedom as there are differences minus strata. The only
// difference of a stratum is taken as known exactly. Empty if no stratum has two differences.
std::optional<double> PairedPValue(const Differences& differences);

// Holm's step-down correction (1979) of p-values that are looked at together. Returns the adjusted
// p-values in the order of the input: the probability that any true null hypothesis has an adjusted
// p-value below 5 % is at most 5 %, whatever their dependence.
std::vector<double> HolmAdjusted(const std::vector<double>& p_values);

// The t that a variable of Student's t distribution with `degrees` >= 1 degrees of freedom exceeds
// with probability `tail`, 1e-9 <= tail <= 0.5.
double StudentQuantile(double tail, int degrees);

}  // namespace cvo::reports
