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

enum class Verdict { kSame, kWithin, kWorse, kBetter, kBlind };
constexpr std::array<const char*, 5> EnumNames(Verdict) {
  return {"same", "within", "WORSE", "better", "not counted"};
}

// Runs of one variant compared with the baseline's, paired by scene and seed. Values are means over
// scenes, weighted by how little their seeds differ; of errors, geometric means.
struct Comparison {
  std::string variant;
  std::string scene;  // empty: all scenes
  std::string metric;
  std::string unit;
  bool relative = false;  // an error: change and tolerance are fractions of the baseline
  double baseline = 0.0;
  double now = 0.0;
  double tolerance = 0.0;  // the smallest change for the worse that is noticed
  std::size_t pairs = 0;
  Verdict verdict = Verdict::kSame;  // kBlind: no change that can be expected would be noticed

  double change() const { return relative ? now / baseline - 1.0 : now - baseline; }
};

struct GateReport {
  std::string suite;
  std::string baseline_commit;
  std::size_t runs = 0;               // number compared with the baseline's
  std::vector<std::string> problems;  // runs and metrics that are missing or not comparable
  // Values of runs on the baseline's platform in an exact check, and how many of them differ. A
  // program with the baseline's estimator has none.
  std::size_t exact = 0;
  std::size_t changed = 0;
  std::vector<Comparison> comparisons;
  std::vector<std::string> notes;

  std::size_t Count(Verdict verdict) const;
  bool Regressed() const { return !problems.empty() || Count(Verdict::kWorse) > 0; }
  bool Failed() const { return Regressed() || changed > 0; }
};

// Compares the runs in a suite's output folder with a baseline. Throws Error only if the folder has
// no readable plan or one of another suite; everything else is in the report: jobs that are
// missing, failed or lost, metrics that are missing or have another contract, options that differ,
// and nothing to compare. With `exact`, any difference of a run on the baseline's platform counts.
GateReport CheckRuns(const std::filesystem::path& folder, const Baseline& baseline,
                     bool exact = true);

// A run to check and the baseline's run with the same keys and seed.
struct RunPair {
  const BaselineJob* baseline = nullptr;
  std::map<std::string, double> values;  // of the run to check, by metric; only comparable ones
};

// Returns one comparison per variant and metric over all scenes and, if there are several, one for
// each scene. The tolerance is what two draws of seeds differ by: the standard error that follows
// from the variance between the baseline's seeds, times Student's quantile for kFalseAlarms, half
// of which the comparisons over all scenes share, half those of one. Few seeds make it wide.
std::vector<Comparison> CompareValues(const Baseline& baseline, const std::vector<RunPair>& pairs);

// The comparisons over all scenes of the baseline with itself: their tolerances are what a check on
// another platform would notice.
std::vector<Comparison> NoticedBy(const Baseline& baseline);

// Throws Error naming `where` and the number of seeds that would do if a check on another platform
// would miss a doubling of the ATE of the camera or a loss of 0.1 success on every scene.
void CheckSensitivity(const Baseline& baseline, const std::string& where);

// "35 %" of an error, "0.04" of anything else.
std::string ToleranceText(const Comparison& comparison);

// "no regression", "changed" or "regression".
std::string GateVerdict(const GateReport& report);

// Returns the report for a terminal, as Markdown, or as JUnit XML with one test case.
std::string GateText(const GateReport& report);
std::string GateMarkdown(const GateReport& report);
std::string GateJunit(const GateReport& report);

// Returns the smallest change of each metric that NoticedBy states, for the variant that needs
// most.
std::string NoticedText(const Baseline& baseline);

}  // namespace cvo::reports
