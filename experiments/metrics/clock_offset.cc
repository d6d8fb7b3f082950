// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/clock_offset.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/error.h"

namespace cvo {
namespace {

// Step of the search. Hand-held cameras shake at less than 10 Hz.
constexpr double kStep_s = 0.01;
constexpr std::size_t kLeastPairs = 20;
constexpr double kLeastExplained = 0.5;
// A second offset is as good if its mean squared residual is less than this times that of the best.
constexpr double kAsGood = 1.5;
constexpr const char* kWhat = "the clock of the ground truth";

// Turn rate between consecutive poses, in the axes of the first one.
struct TurnRate {
  std::int64_t from_ns;
  std::int64_t to_ns;
  Eigen::Vector3d rad_per_s;
};

Eigen::Vector3d RateBetween(const RigidTransform& a, const RigidTransform& b, double dt_s) {
  return LogSo3(a.rotation().conjugate() * b.rotation()) / dt_s;
}

std::vector<TurnRate> TurnRates(const Trajectory& trajectory) {
  std::vector<TurnRate> rates;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const TimedPose& a = trajectory[i - 1];
    const TimedPose& b = trajectory[i];
    const double dt_s = 1e-9 * static_cast<double>(b.timestamp_ns - a.timestamp_ns);
    rates.push_back({a.timestamp_ns, b.timestamp_ns,
                     RateBetween(a.world_from_camera, b.world_from_camera, dt_s)});
  }
  return rates;
}

std::int64_t Nanoseconds(double seconds) { return std::llround(1e9 * seconds); }

std::optional<Eigen::Vector3d> TrueRate(const Trajectory& truth, const TurnRate& rate,
                                        double offset_s) {
  const std::int64_t offset_ns = Nanoseconds(offset_s);
  const auto a = InterpolatePose(truth, rate.from_ns + offset_ns);
  const auto b = InterpolatePose(truth, rate.to_ns + offset_ns);
  if (!a || !b) return std::nullopt;
  return RateBetween(*a, *b, 1e-9 * static_cast<double>(rate.to_ns - rate.from_ns));
}

struct Agreement {
  std::size_t pairs = 0;
  double squares = 0.0;  // sum over residuals, (rad/s)^2
  double spread = 0.0;   // sum over the estimate's rates about their mean, (rad/s)^2
  double MeanSquare() const { return squares / static_cast<double>(3 * pairs); }
};

// Empty if fewer than half of the estimate's rates, or fewer than kLeastPairs, have a true one.
std::optional<Agreement> Agree(const Trajectory& truth, const std::vector<TurnRate>& rates,
                               double offset_s) {
  Agreement agreement;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (const TurnRate& rate : rates) {
    const auto true_rate = TrueRate(truth, rate, offset_s);
    if (!true_rate) continue;
    ++agreement.pairs;
    agreement.squares += (rate.rad_per_s - *true_rate).squaredNorm();
    sum += rate.rad_per_s;
    squares += rate.rad_per_s.squaredNorm();
  }
  if (agreement.pairs < std::max(kLeastPairs, (rates.size() + 1) / 2)) return std::nullopt;
  agreement.spread = squares - sum.squaredNorm() / static_cast<double>(agreement.pairs);
  return agreement;
}

// Gauss-Newton in one unknown. Returns the sum of the squared derivatives of the true rates in
// `information`.
double Refine(const Trajectory& truth, const std::vector<TurnRate>& rates, double start_s,
              double& information) {
  constexpr int kRounds = 20;
  constexpr double kConverged_s = 1e-7;
  const double half_s = 0.5 * kStep_s;
  double offset_s = start_s;
  for (int round = 0; round < kRounds; ++round) {
    double slope = 0.0;
    information = 0.0;
    for (const TurnRate& rate : rates) {
      const auto at = TrueRate(truth, rate, offset_s);
      const auto before = TrueRate(truth, rate, offset_s - half_s);
      const auto after = TrueRate(truth, rate, offset_s + half_s);
      if (!at || !before || !after) continue;
      const Eigen::Vector3d derivative = (*after - *before) / kStep_s;
      slope += derivative.dot(rate.rad_per_s - *at);
      information += derivative.squaredNorm();
    }
    if (information == 0.0) break;
    const double step_s = slope / information;
    offset_s = std::clamp(offset_s + step_s, start_s - kStep_s, start_s + kStep_s);
    if (std::abs(step_s) < kConverged_s) break;
  }
  return offset_s;
}

// Agreement at each step of the search, from -steps to steps.
std::vector<std::optional<Agreement>> Search(const Trajectory& truth,
                                             const std::vector<TurnRate>& rates, int steps) {
  std::vector<std::optional<Agreement>> found;
  for (int i = -steps; i <= steps; ++i) found.push_back(Agree(truth, rates, i * kStep_s));
  return found;
}

double SquareOr(const std::optional<Agreement>& agreement) {
  return agreement ? agreement->MeanSquare() : std::numeric_limits<double>::infinity();
}

// The offset refined from one step of the search, with its information and agreement.
struct Minimum {
  double offset_s = 0.0;
  double information = 0.0;
  Agreement agreement;
};

Minimum RefineFrom(const Trajectory& truth, const std::vector<TurnRate>& rates, double start_s,
                   const Agreement& at_start) {
  Minimum minimum;
  minimum.offset_s = Refine(truth, rates, start_s, minimum.information);
  minimum.agreement = Agree(truth, rates, minimum.offset_s).value_or(at_start);
  return minimum;
}

// Throws Error unless the minimum lies within the search range and is unique. The other minima are
// refined before they are compared, because a sharp one between two steps of the search looks worse
// there than it is.
void RequireOneMinimum(const Trajectory& truth, const std::vector<TurnRate>& rates,
                       const std::vector<std::optional<Agreement>>& found, std::size_t best,
                       const Minimum& minimum) {
  const int steps = static_cast<int>(found.size() / 2);
  const auto offset_s = [&](std::size_t i) { return (static_cast<int>(i) - steps) * kStep_s; };
  if (best == 0 || best + 1 == found.size()) {
    ThrowError(kWhat, StrCat("the best agreement at ", offset_s(best), " s, the end of the search"),
               "a larger range, or motions that determine it");
  }
  const double limit = kAsGood * minimum.agreement.MeanSquare();
  for (std::size_t i = 1; i + 1 < found.size(); ++i) {
    const double square = SquareOr(found[i]);
    if (i == best || !found[i] || square > SquareOr(found[i - 1]) ||
        square > SquareOr(found[i + 1])) {
      continue;
    }
    const Minimum other = RefineFrom(truth, rates, offset_s(i), *found[i]);
    const bool is_same = std::abs(other.offset_s - minimum.offset_s) < kStep_s;
    if (is_same || other.agreement.MeanSquare() >= limit) continue;
    ThrowError(kWhat,
               StrCat("rotation rates that agree as well at ", offset_s(i), " s as at ",
                      offset_s(best), " s"),
               "a smaller range, or motions that do not repeat");
  }
}

}  // namespace

ClockOffset EstimateClockOffset(const Trajectory& truth, const Trajectory& estimate,
                                double most_s) {
  Require(most_s > 0.0 && most_s <= kMostClockOffset_s, "EstimateClockOffset: range");
  const std::vector<TurnRate> rates = TurnRates(estimate);
  const int steps = std::max(1, static_cast<int>(std::ceil(most_s / kStep_s)));
  const std::vector<std::optional<Agreement>> found = Search(truth, rates, steps);
  const auto best = static_cast<std::size_t>(
      std::min_element(found.begin(), found.end(),
                       [](const auto& a, const auto& b) { return SquareOr(a) < SquareOr(b); }) -
      found.begin());
  if (!found[best]) {
    ThrowError(kWhat, StrCat(rates.size(), " pairs of poses, too few of them within the truth"),
               StrCat(kLeastPairs, " and half of all, at some offset up to ", most_s, " s"));
  }
  const Minimum minimum =
      RefineFrom(truth, rates, (static_cast<int>(best) - steps) * kStep_s, *found[best]);
  const Agreement& agreement = minimum.agreement;
  ClockOffset clock;
  clock.offset_s = minimum.offset_s;
  clock.pairs = agreement.pairs;
  clock.explained = 1.0 - agreement.squares / agreement.spread;
  clock.residual_rad_per_s = std::sqrt(agreement.MeanSquare());
  if (!(clock.explained >= kLeastExplained)) {
    ThrowError(kWhat,
               StrCat("rotation rates of which the truth explains ",
                      std::lround(100.0 * std::max(0.0, clock.explained)), " %"),
               StrCat(std::lround(100.0 * kLeastExplained),
                      " % or more: a camera that turns back and forth"));
  }
  RequireOneMinimum(truth, rates, found, best, minimum);
  clock.deviation_s = clock.residual_rad_per_s / std::sqrt(minimum.information);
  return clock;
}

}  // namespace cvo
