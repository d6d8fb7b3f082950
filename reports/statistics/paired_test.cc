// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/statistics/estimate.h"

namespace cvo::reports {
namespace {

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

constexpr double kTwoSidedTail = 0.025;
constexpr double kMissTail = 0.2;  // 80 % power

struct Moments {
  double mean = 0.0;      // over strata
  double variance = 0.0;  // variance of that mean
  double spread = 0.0;    // variance of a difference, averaged over strata with several
  int degrees = 0;
};

Moments MomentsOf(const Differences& differences) {
  Moments moments;
  const auto strata = static_cast<double>(differences.size());
  double several = 0.0;
  for (const std::vector<double>& stratum : differences) {
    const auto n = static_cast<double>(stratum.size());
    moments.mean += MeanOf(stratum) / strata;
    if (stratum.size() < 2) continue;
    const double variance = SquaresAroundMean(stratum) / (n - 1.0);
    moments.variance += variance / n / (strata * strata);
    moments.spread += variance;
    moments.degrees += static_cast<int>(stratum.size()) - 1;
    several += 1.0;
  }
  if (several > 0.0) moments.spread /= several;
  return moments;
}

}  // namespace

double StudentTail(double t, int degrees) {
  Require(t >= 0.0, "StudentTail: t of at least 0");
  Require(degrees >= 1, "StudentTail: at least one degree of freedom");
  degrees = std::min(degrees, kMaxDegrees);
  return std::max(Tail(std::atan(t / std::sqrt(static_cast<double>(degrees))), degrees), 0.0);
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

std::optional<std::size_t> PairsNeeded(const Differences& differences, double size) {
  const Moments moments = MomentsOf(differences);
  if (moments.degrees == 0) return std::nullopt;
  const std::size_t strata = differences.size();
  const auto needed = [&](std::size_t pairs) {
    const int degrees = static_cast<int>(std::min<std::size_t>(pairs - strata, 1'000));
    const double quantiles =
        StudentQuantile(kTwoSidedTail, degrees) + StudentQuantile(kMissTail, degrees);
    return quantiles * quantiles * moments.spread / (size * size);
  };
  constexpr std::size_t kMany = 1'000'000;
  std::size_t pairs = std::max<std::size_t>(
      strata + 1, static_cast<std::size_t>(std::min(needed(kMany), double{kMany})));
  while (pairs < kMany && static_cast<double>(pairs) < needed(pairs)) ++pairs;
  return pairs;
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
