// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/gate/baseline.h"

namespace cvo::reports {

// Probability that noise between seeds alone fails a whole check.
inline constexpr double kFalseAlarms = 0.01;

enum class Verdict { kSame, kWithin, kWorse, kBetter };
constexpr std::array<const char*, 4> EnumNames(Verdict) {
  return {"same", "within", "WORSE", "better"};
}

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

struct GateReport {
  std::string suite;
  std::string baseline_commit;
  std::size_t runs = 0;               // number compared with the baseline's
  std::vector<std::string> problems;  // runs and metrics that are missing or not comparable
  // Number of comparisons that are not the same, in an exact check on the baseline's platform. A
  // program with the baseline's estimator has none.
  std::size_t changed = 0;
  std::vector<Comparison> comparisons;
  std::vector<std::string> notes;

  std::size_t Count(Verdict verdict) const;
  bool Regressed() const { return !problems.empty() || Count(Verdict::kWorse) > 0; }
  bool Failed() const { return Regressed() || changed > 0; }
};

// Compares the runs in a suite's output folder with a baseline. Throws Error only if the folder has
// no readable plan; everything else is in the report: jobs that are missing, failed or lost,
// metrics that are missing or have another contract, and nothing to compare. With `exact`, any
// difference also counts if the baseline is of the same platform; otherwise a note says that it is
// not.
GateReport CheckRuns(const std::filesystem::path& folder, const Baseline& baseline,
                     bool exact = false);

// A run to check and the baseline's run with the same keys and seed.
struct RunPair {
  const BaselineJob* baseline = nullptr;
  std::map<std::string, double> values;  // of the run to check, by metric; only comparable ones
};

// Returns one comparison per variant and metric over all scenes and, if there are several, one for
// each scene. The tolerance of a mean difference is what two draws of seeds differ by: the standard
// error that follows from the variance between the baseline's seeds, times Student's quantile for
// kFalseAlarms shared by all comparisons. Few seeds make it wide.
std::vector<Comparison> CompareValues(const Baseline& baseline, const std::vector<RunPair>& pairs);

// "no regression", "changed" or "regression".
std::string GateVerdict(const GateReport& report);

// Returns the report for a terminal, as Markdown, or as JUnit XML with one test case.
std::string GateText(const GateReport& report);
std::string GateMarkdown(const GateReport& report);
std::string GateJunit(const GateReport& report);

}  // namespace cvo::reports
