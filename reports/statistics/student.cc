// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/student.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/error.h"

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

}  // namespace cvo::reports
