// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cvo::reports {

enum class Verdict { kSame, kWithin, kWorse, kBetter };

// Runs of one variant against the baseline's, paired by scene and seed. Means over scenes of the
// mean over their seeds, in the metric's unit.
struct Comparison {
  std::string variant;
  std::string scene;  // empty: all of them
  std::string metric;
  std::string unit;
  double baseline = 0.0;
  double now = 0.0;
  double tolerance = 0.0;
  std::size_t pairs = 0;
  Verdict verdict = Verdict::kSame;

  double difference() const { return now - baseline; }
};

// Time of a variant's estimate, as a ratio to kTimeReference in the same runs.
struct TimeComparison {
  std::string variant;
  double baseline = 0.0;  // ratio, geometric mean
  double now = 0.0;
  double limit = 1.0;  // now / baseline above which it is slower, below 1 / limit faster
  std::size_t pairs = 0;
  Verdict verdict = Verdict::kSame;
};

// Why a check fails apart from its numbers: a run or a metric that is not there or not comparable.
struct GateProblem {
  std::string where;
  std::string message;
};

struct GateReport {
  std::string suite;
  std::string baseline_commit;
  std::string baseline_build;
  std::string build;     // of the runs that were checked
  std::size_t runs = 0;  // compared with the baseline's
  std::vector<GateProblem> problems;
  // Comparisons that are not the same, in an exact check on the baseline's platform: what a program
  // with the baseline's estimator would not show.
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
