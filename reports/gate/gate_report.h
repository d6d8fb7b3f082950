// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cvo::reports {

enum class Verdict { kSame, kWithin, kWorse, kBetter };

// Runs of one variant compared with the baseline's, paired by scene and seed. Values are means over
// scenes of the mean over their seeds, in the metric's unit.
struct Comparison {
  std::string variant;
  std::string scene;  // empty: all scenes
  std::string metric;
  std::string unit;
  double baseline = 0.0;
  double now = 0.0;
  double tolerance = 0.0;
  std::size_t pairs = 0;
  Verdict verdict = Verdict::kSame;

  double difference() const { return now - baseline; }
};

// Estimate time of a variant, as a ratio to that of kTimeReference in the same runs.
struct TimeComparison {
  std::string variant;
  double baseline = 0.0;  // geometric mean of the ratios
  double now = 0.0;
  double limit = 1.0;  // slower if now / baseline exceeds it, faster if below 1 / limit
  std::size_t pairs = 0;
  Verdict verdict = Verdict::kSame;
};

// A reason other than its numbers for which a check fails: a run or a metric that is missing or not
// comparable.
struct GateProblem {
  std::string where;
  std::string message;
};

struct GateReport {
  std::string suite;
  std::string baseline_commit;
  std::string baseline_build;
  std::string build;     // of the checked runs
  std::size_t runs = 0;  // number compared with the baseline's
  std::vector<GateProblem> problems;
  // Number of comparisons that are not the same, in an exact check on the baseline's platform. A
  // program with the baseline's estimator has none.
  std::size_t changed = 0;
  std::vector<Comparison> comparisons;
  std::vector<TimeComparison> times;
  std::vector<std::string> time_problems;
  std::vector<std::string> notes;

  std::size_t Count(Verdict verdict) const;
  std::size_t Differing() const { return comparisons.size() - Count(Verdict::kSame); }
  bool Regressed() const { return !problems.empty() || Count(Verdict::kWorse) > 0; }
  bool Failed() const { return Regressed() || changed > 0; }
  bool Slower() const;
};

const char* ToString(Verdict verdict);

}  // namespace cvo::reports
