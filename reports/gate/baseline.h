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

struct BaselineMetric {
  std::string name;  // a name that FindEntry knows
  MetricUnit unit = MetricUnit::kOne;
  std::map<std::string, Contract> contracts;  // by dataset type

  // Returns "higher" or "lower". Throws Error for a metric that the gate does not know.
  static const char* Better(const std::string& name);

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("name", self.name);
    archive.Field("unit", self.unit);
    archive.Constant("better", Better(self.name));
    archive.Field("contracts", self.contracts);
  }
};

// The results of one run when the baseline was written.
struct BaselineJob {
  std::map<std::string, std::string> keys;  // PlannedRun::keys
  std::uint64_t seed = 0;
  std::string type;  // dataset type
  // Hash of its images; distinguishes a different rendering from a different estimate.
  std::string content;
  std::optional<int> frames;             // of the run; absent from older files
  std::string status;                    // "ok" or "lost"
  std::map<std::string, double> values;  // by metric, without those that the run lacks
  std::optional<double> time_ratio;      // estimate time divided by that of kTimeReference

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("keys", self.keys);
    archive.Field("seed", self.seed);
    archive.Field("type", self.type);
    archive.Field("content", self.content);
    archive.Optional("frames", self.frames);
    archive.Field("status", self.status);
    archive.Field("values", self.values);
    archive.Optional("time_ratio", self.time_ratio);
  }
};

struct BaselineBuild {
  std::string identity;
  std::string cpu_level = "avx2";  // of the build; absent from older files, which needed this one
  std::string commit;              // for human readers
  std::string platform;            // BuildInfo::Platform; absent from older files

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("identity", self.identity);
    archive.Added("cpu_level", self.cpu_level);
    archive.Field("commit", self.commit);
    archive.Optional("platform", self.platform);
  }
};

// The reference with which later runs of a suite are compared.
struct Baseline {
  static constexpr int kSchemaVersion = 2;
  static constexpr const char* kKind = "baseline";

  std::string suite;
  BaselineBuild build;
  // Seeds that must be among the checked runs. The others only serve to estimate the spread between
  // seeds.
  std::vector<std::uint64_t> seeds;
  std::vector<BaselineMetric> metrics;
  std::vector<BaselineJob> jobs;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("suite", self.suite);
    archive.Field("build", self.build);
    archive.Field("seeds", self.seeds);
    archive.Field("metrics", self.metrics);
    archive.Field("jobs", self.jobs);
  }
};

// Throws Error naming the file and the field for another schema, an incomplete file, an unknown
// metric, a duplicate job, or no values to compare.
Baseline ReadBaseline(const std::filesystem::path& file);

// Returns the text of its file with one line per metric and per run, so that an updated file
// differs only where runs do.
std::string BaselineText(const Baseline& baseline);

}  // namespace cvo::reports
