// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/base/rng.h"

namespace cvo::reports {
namespace {

constexpr int kResamples = 5000;

// A body or a scene after averaging over its repetitions.
struct Unit {
  std::array<Part, 2> parts;  // value, reference
};

// What is resampled: scenes within their families, or the bodies of the only scene.
struct Strata {
  std::vector<std::vector<Unit>> units;
  Within within = Within::kMean;  // how the figure of a stratum is computed from its units
  std::size_t scenes = 0;
  std::size_t bodies = 0;

  bool of_scenes() const { return scenes > 1; }
};

// Ordered containers, since a floating-point sum depends on the order of its terms.
using Repetitions = std::map<std::string, const Sample*>;
using Bodies = std::map<std::string, Repetitions>;
using Families = std::map<std::string, std::map<std::string, Bodies>>;

void Add(const Part& part, Part& sum) {
  sum.sum += part.sum;
  sum.weight += part.weight;
}

Families Order(const std::vector<Sample>& samples) {
  Families ordered;
  for (const Sample& sample : samples) {
    const Sample*& slot = ordered[sample.family][sample.scene][sample.body][sample.repetition];
    if (slot != nullptr) {
      ThrowError("statistics",
                 StrCat(sample.scene, ", ", sample.body, ", ", sample.repetition, " twice"),
                 "each sample once");
    }
    slot = &sample;
  }
  return ordered;
}

std::vector<Unit> AverageRepetitions(const Bodies& bodies) {
  std::vector<Unit> units;
  for (const auto& [body, repetitions] : bodies) {
    Unit mean = {{Part{0.0, 0.0}, Part{0.0, 0.0}}};
    for (const auto& [repetition, sample] : repetitions) {
      Add(sample->value, mean.parts[0]);
      Add(sample->reference, mean.parts[1]);
    }
    for (Part& part : mean.parts) {
      part.sum /= static_cast<double>(repetitions.size());
      part.weight /= static_cast<double>(repetitions.size());
    }
    units.push_back(mean);
  }
  return units;
}

double Figure(const Part& part, Within within) {
  return within == Within::kSum ? part.sum : part.sum / part.weight;
}

Differences DifferencesOf(const Strata& strata) {
  Differences differences;
  for (const std::vector<Unit>& units : strata.units) {
    differences.emplace_back();
    for (const Unit& unit : units) {
      const auto& [value, reference] = unit.parts;
      if (value.weight <= 0.0 || reference.weight <= 0.0) continue;
      differences.back().push_back(Figure(value, strata.within) - Figure(reference, strata.within));
    }
  }
  std::erase_if(differences, [](const auto& stratum) { return stratum.empty(); });
  return differences;
}

double Quantile(const std::vector<double>& sorted, double fraction) {
  const double at = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(at));
  const auto above = static_cast<std::size_t>(std::ceil(at));
  return sorted[below] + (at - std::floor(at)) * (sorted[above] - sorted[below]);
}

// The interval that holds the middle kConfidence of the values.
std::optional<Interval> MiddleRange(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double tail = 0.5 * (1.0 - kConfidence);
  return Interval{Quantile(values, tail), Quantile(values, 1.0 - tail)};
}

constexpr std::uint64_t kSeed = 1;

// Draws units.size() - 1 units. Sums are scaled up, since the drawn units stand for all.
void Resample(const std::vector<Unit>& units, Within within, Rng& rng, std::vector<Unit>& drawn) {
  const std::size_t draws = units.size() - 1;
  const double scale =
      within == Within::kSum ? static_cast<double>(units.size()) / static_cast<double>(draws) : 1.0;
  drawn.resize(draws);
  for (Unit& unit : drawn) {
    unit = units[rng.UniformInt(units.size())];
    for (Part& part : unit.parts) part.sum *= scale;
  }
}

// The mean over strata; empty if the weights of a stratum sum to 0.
std::optional<std::array<double, 2>> MeanOverStrata(const std::vector<std::vector<Unit>>& strata,
                                                    Within within) {
  if (strata.empty()) return std::nullopt;
  std::array<double, 2> means = {0.0, 0.0};
  for (const std::vector<Unit>& units : strata) {
    for (std::size_t which = 0; which < means.size(); ++which) {
      Part total = {0.0, 0.0};
      for (const Unit& unit : units) Add(unit.parts[which], total);
      if (total.weight <= 0.0) return std::nullopt;
      means[which] += within == Within::kSum ? total.sum : total.sum / total.weight;
    }
  }
  for (double& mean : means) mean /= static_cast<double>(strata.size());
  return means;
}

std::optional<Strata> GroupSamples(const std::vector<Sample>& samples, Within within) {
  Strata strata;
  std::vector<Unit> bodies;  // of the last scene
  for (const auto& [family, scenes] : Order(samples)) {
    strata.units.emplace_back();
    for (const auto& [scene, of_scene] : scenes) {
      bodies = AverageRepetitions(of_scene);
      const auto figure = MeanOverStrata({bodies}, within);
      if (!figure) return std::nullopt;
      strata.units.back().push_back({{Part{(*figure)[0]}, Part{(*figure)[1]}}});
      ++strata.scenes;
      strata.bodies += bodies.size();
    }
  }
  if (strata.scenes == 0) return std::nullopt;
  if (!strata.of_scenes()) {
    strata.units = {bodies};
    strata.within = within;
  }
  return strata;
}

// Value and reference of resampled strata. For the same numbers of units, the same units are drawn.
// Of n units, n - 1 are drawn with replacement (McCarthy and Snowden 1985), since drawing n makes
// the interval of a mean too narrow by sqrt((n - 1) / n). Empty if no stratum has two units.
std::vector<std::array<double, 2>> Bootstrap(const std::vector<std::vector<Unit>>& strata,
                                             Within within) {
  const bool can_vary =
      std::any_of(strata.begin(), strata.end(), [](const auto& units) { return units.size() > 1; });
  if (!can_vary) return {};
  Rng rng(kSeed, "bootstrap");
  std::vector<std::vector<Unit>> drawn = strata;
  std::vector<std::array<double, 2>> means;
  means.reserve(kResamples);
  for (int i = 0; i < kResamples; ++i) {
    for (std::size_t s = 0; s < strata.size(); ++s) {
      if (strata[s].size() > 1) Resample(strata[s], within, rng, drawn[s]);
    }
    if (const auto mean = MeanOverStrata(drawn, within)) means.push_back(*mean);
  }
  return means;
}

// Above this number, the distribution equals the normal one to about four digits.
constexpr int kMaxDegrees = 1000;

// The probability of exceeding sqrt(degrees) * tan(theta), theta >= 0.
double Tail(double theta, int degrees) {
  const double cosine = std::cos(theta);
  const double squared = cosine * cosine;
  const bool odd = degrees % 2 == 1;
  double term = odd ? cosine : 1.0;
  double sum = degrees == 1 ? 0.0 : term;
  for (int k = odd ? 3 : 2; k <= degrees - 2; k += 2) {
    term *= squared * (k - 1.0) / k;
    sum += term;
  }
  const double inside =
      odd ? (theta + std::sin(theta) * sum) * 2.0 / std::numbers::pi : std::sin(theta) * sum;
  return 0.5 * (1.0 - inside);
}

// The probability of exceeding t >= 0, by the finite series of the distribution function
// (Abramowitz and Stegun, 26.7.3 and 26.7.4).
double StudentTail(double t, int degrees) {
  Require(t >= 0.0, "StudentTail: t of at least 0");
  Require(degrees >= 1, "StudentTail: at least one degree of freedom");
  degrees = std::min(degrees, kMaxDegrees);
  return std::max(Tail(std::atan(t / std::sqrt(static_cast<double>(degrees))), degrees), 0.0);
}

struct Moments {
  double mean = 0.0;      // over strata
  double variance = 0.0;  // variance of that mean
  int degrees = 0;
};

Moments MomentsOf(const Differences& differences) {
  Moments moments;
  const auto strata = static_cast<double>(differences.size());
  for (const std::vector<double>& stratum : differences) {
    const auto n = static_cast<double>(stratum.size());
    moments.mean += MeanOf(stratum) / strata;
    if (stratum.size() < 2) continue;
    const double variance = SquaresAroundMean(stratum) / (n - 1.0);
    moments.variance += variance / n / (strata * strata);
    moments.degrees += static_cast<int>(stratum.size()) - 1;
  }
  return moments;
}

}  // namespace

std::optional<Estimate> EstimateMean(const std::vector<Sample>& samples, Within within) {
  const std::optional<Strata> strata = GroupSamples(samples, within);
  const auto mean = strata ? MeanOverStrata(strata->units, strata->within) : std::nullopt;
  if (!mean) return std::nullopt;
  Estimate estimate;
  estimate.value = (*mean)[0];
  estimate.scenes = strata->scenes;
  estimate.bodies = strata->bodies;
  std::vector<double> values;
  for (const auto& resampled : Bootstrap(strata->units, strata->within)) {
    values.push_back(resampled[0]);
  }
  estimate.interval = MiddleRange(std::move(values));
  return estimate;
}

std::optional<PairedEstimate> EstimateDifference(const std::vector<Sample>& pairs, Within within) {
  const std::optional<Strata> strata = GroupSamples(pairs, within);
  const auto mean = strata ? MeanOverStrata(strata->units, strata->within) : std::nullopt;
  if (!mean) return std::nullopt;
  std::vector<double> differences;
  for (const auto& [value, reference] : Bootstrap(strata->units, strata->within)) {
    differences.push_back(value - reference);
  }
  PairedEstimate estimate{.value = (*mean)[0],
                          .reference_value = (*mean)[1],
                          .difference = (*mean)[0] - (*mean)[1],
                          .interval = MiddleRange(std::move(differences)),
                          .percent = {},
                          .p_value = PairedPValue(DifferencesOf(*strata)),
                          .pairs = strata->of_scenes() ? strata->scenes : strata->bodies};
  if ((*mean)[1] > 0.0) estimate.percent = 100.0 * estimate.difference / (*mean)[1];
  return estimate;
}

double StudentQuantile(double tail, int degrees) {
  Require(tail >= 1e-9 && tail <= 0.5, "StudentQuantile: a tail within [1e-9, 0.5]");
  Require(degrees >= 1, "StudentQuantile: at least one degree of freedom");
  degrees = std::min(degrees, kMaxDegrees);
  double low = 0.0;
  double high = std::numbers::pi / 2.0;
  double middle = std::midpoint(low, high);
  while (low < middle && middle < high) {
    (Tail(middle, degrees) > tail ? low : high) = middle;
    middle = std::midpoint(low, high);
  }
  return std::sqrt(static_cast<double>(degrees)) * std::tan(low);
}

std::optional<double> PairedPValue(const Differences& differences) {
  const Moments moments = MomentsOf(differences);
  if (moments.degrees == 0) return std::nullopt;
  if (moments.mean == 0.0) return 1.0;
  const double error = std::sqrt(moments.variance);
  if (error == 0.0) return 0.0;
  return 2.0 * StudentTail(std::abs(moments.mean) / error, moments.degrees);
}

std::vector<double> HolmAdjusted(const std::vector<double>& p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> adjusted(p_values.size());
  double largest = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const auto left = static_cast<double>(order.size() - rank);
    largest = std::max(largest, std::min(1.0, left * p_values[order[rank]]));
    adjusted[order[rank]] = largest;
  }
  return adjusted;
}

}  // namespace cvo::reports
