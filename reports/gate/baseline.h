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
  std::string name;  // FindEntry knows it
  MetricUnit unit = MetricUnit::kOne;
  std::map<std::string, Contract> contracts;  // by type of dataset

  // "higher" or "lower"; empty for a metric that the gate does not know.
  static const char* Better(const std::string& name);

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("name", self.name);
    archive.Field("unit", self.unit);
    archive.Constant("better", Better(self.name));
    archive.Field("contracts", self.contracts);
  }
};

// What a run reached when the baseline was written.
struct BaselineJob {
  std::map<std::string, std::string> keys;  // PlannedRun::keys
  std::uint64_t seed = 0;
  std::string type;  // of dataset
  std::string
      content;  // of its images; distinguishes a different rendering from a different estimate
  std::optional<int> frames;             // of the run; older files lack it
  std::string status;                    // "ok" or "lost"
  std::map<std::string, double> values;  // by metric; those that the run does not have lack
  std::optional<double> time_ratio;      // time of the estimate over that of kTimeReference

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
  std::string cpu_level = "avx2";  // of the processor; older files lack it, and needed this one
  std::string commit;              // for people
  std::string platform;            // BuildInfo::Platform; older files lack it

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("identity", self.identity);
    archive.Added("cpu_level", self.cpu_level);
    archive.Field("commit", self.commit);
    archive.Optional("platform", self.platform);
  }
};

// What later runs of a suite are held against.
struct Baseline {
  static constexpr int kSchemaVersion = 2;
  static constexpr const char* kKind = "baseline";

  std::string suite;
  BaselineBuild build;
  // Seeds that a checked run must have; the others only tell how far seeds are apart.
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

// Throws Error naming the file and the field: another schema, half-written, a metric without rule,
// a job twice, nothing to compare.
Baseline ReadBaseline(const std::filesystem::path& file);

// Its file with a line per metric and per run, so that a renewed one differs where runs do.
std::string BaselineText(const Baseline& baseline);

}  // namespace cvo::reports
