// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/record/suite_runs.h"

namespace cvo::reports {

using RunKeys = std::map<std::string, std::string>;  // PlannedRun::keys

struct BaselineMetric {
  std::string name;  // a name that FindEntry knows
  MetricUnit unit = MetricUnit::kOne;
  std::map<std::string, Contract> contracts;  // by dataset type
  std::string better = {};                    // "higher" or "lower": for human readers

  CVO_FIELDS(name, unit, better, contracts);
};

// The results of one run when the baseline was written.
struct BaselineJob {
  RunKeys keys;
  std::uint64_t seed = 0;
  std::string type;  // dataset type
  // Hash of its images; distinguishes a different rendering from a different estimate.
  std::string content;
  std::string images;                    // RunSequence::images; absent from older files
  std::optional<int> frames;             // of the run; absent from older files
  std::string status;                    // "ok" or "lost"
  std::map<std::string, double> values;  // by metric, without those that the run lacks

  CVO_RECORD(CVO_FIELD(keys, seed, type, content) CVO_OPTIONAL(images, frames)
                 CVO_FIELD(status, values));
};

struct BaselineBuild {
  std::string identity;
  std::string commit;    // for human readers
  std::string platform;  // BuildInfo::Platform; absent from older files

  CVO_RECORD(CVO_FIELD(identity, commit) CVO_OPTIONAL(platform));
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
  // Those that all its runs share, as JSON texts by path; absent from older files.
  std::map<std::string, std::string> options;
  std::vector<BaselineMetric> metrics;
  std::vector<BaselineJob> jobs;
  std::string checksum;  // ChecksumOf; absent from older files

  CVO_RECORD(CVO_FIELD(suite, build, seeds) CVO_OPTIONAL(options) CVO_FIELD(metrics, jobs)
                 CVO_OPTIONAL(checksum));
};

// Throws Error naming the file and the field for another schema, an incomplete file, an unknown
// metric, a job or metric that is there twice, no seed or no values to compare, and another
// checksum.
Baseline ReadBaseline(const std::filesystem::path& file);

// Returns the text of its file with one line per metric and per run, so that an updated file
// differs only where runs do.
std::string BaselineText(const Baseline& baseline);

// Makes a baseline from a folder that a suite was run to. `gate_seeds` is how many of its seeds,
// the lowest first, must be among checked runs (0: all). Throws Error naming the obstacle: a job
// that is not done, contracts that differ, fewer than two seeds, no metric, or a gate that sees too
// little (CheckSensitivity).
Baseline MakeBaseline(const std::filesystem::path& folder, std::size_t gate_seeds = 0);

// The runs of a folder that the gate considers: those of the program's own variants.
struct GateRuns {
  std::string suite;
  std::vector<std::string> metrics;  // those read, as far as FindEntry knows them
  std::vector<SuiteRun> runs;
};

// Reads the runs with these metrics or, if there are none, with the table's, the ATE of the camera
// and the success of bodies, and their coverage.
// Throws Error as ReadPlan does.
GateRuns ReadGateRuns(const std::filesystem::path& folder, std::vector<std::string> metrics = {});

// Returns the contract that must be equal for runs on one dataset type to be comparable.
Contract GateContract(const RunSummary& run, const MetricValue& metric);

// Returns a label such as "indoor_1, detections good": the keys other than the variant, unless they
// are "none".
std::string SceneLabel(const RunKeys& keys);

// Returns a label such as "2d3d on indoor_1, detections good, seed 2".
std::string RunLabel(const RunKeys& keys, std::uint64_t seed);

}  // namespace cvo::reports
