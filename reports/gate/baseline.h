// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/results/contract.h"

namespace cvo::reports {

inline constexpr int kBaselineSchemaVersion = 2;

struct BaselineMetric {
  std::string name;  // FindEntry knows it
  MetricUnit unit = MetricUnit::kOne;
  std::map<std::string, Contract> contracts;  // by type of dataset
};

// What a run reached when the baseline was written.
struct BaselineJob {
  std::map<std::string, std::string> keys;  // PlannedRun::keys
  std::uint64_t seed = 0;
  std::string type;  // of dataset
  std::string
      content;  // of its images; distinguishes a different rendering from a different estimate
  std::string status;                    // "ok" or "lost"
  std::map<std::string, double> values;  // by metric; those that the run does not have lack
  std::optional<double> time_ratio;      // time of the estimate over that of kTimeReference
};

// What later runs of a suite are held against.
struct Baseline {
  std::string suite;
  std::string build;               // identity
  std::string cpu_level = "avx2";  // of the processor; older files do not say, and needed this one
  std::string commit;              // for people
  // Seeds that a checked run must have; the others only tell how far seeds are apart.
  std::vector<std::uint64_t> seeds;
  std::vector<BaselineMetric> metrics;
  std::vector<BaselineJob> jobs;
};

// One job per line. Throws Error naming a value that is not finite.
std::string BaselineJson(const Baseline& baseline);

// Throws Error naming the file and the field: another schema, half-written, a metric without rule,
// a job twice, nothing to compare.
Baseline ReadBaseline(const std::filesystem::path& file);

}  // namespace cvo::reports
