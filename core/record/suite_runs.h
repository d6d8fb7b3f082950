// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json_record.h"
#include "core/files/text_file.h"
#include "core/record/run_summary.h"

namespace cvo::reports {

struct PlanSuite {
  std::string name;
  std::string about;
  std::string split;  // of its scenes

  CVO_RECORD(CVO_FIELD(name) CVO_ADDED(about, split));
};

// How the results are tabulated.
struct PlanTable {
  // Keys that distinguish rows: sequence, detections, variant, oracle, or an option's path.
  std::vector<std::string> rows = {"variant"};
  std::vector<std::string> metrics;
  // Row with which the others are compared: a variant, key=value such as "oracle=none", or
  // kRowAbove; empty: none.
  std::string reference;

  CVO_RECORD(CVO_FIELD(rows, metrics) CVO_ADDED(reference));
};

// Value of PlanJob::missing for a scene that only has to be rendered first.
inline constexpr char kNotRendered[] = "not rendered yet";

// One planned run.
struct PlanJob {
  std::string sequence;
  std::string family;  // family that the scene is drawn from; empty: none
  std::string split;   // "development", "test", "none"; "given": images; empty: an older plan
  std::string detections;
  std::string variant;  // empty for another system
  std::string system;   // name of another system whose files are scored; empty for a variant
  std::uint64_t seed = 0;
  std::vector<std::string> oracle;
  Json parameters = Json::object();  // value by path of each option that the suite varies
  bool landmarks = false;
  std::string folder;
  std::string missing;  // why there is no sequence
  int frames = 0;
  std::string content;      // hash of the sequence; empty: not stated
  std::string input;        // what the front end reads and how
  std::string job;          // empty where the sequence is missing
  std::uint64_t entry = 0;  // index of the sequence in the definition

  // Returns the variant that its result states.
  std::string ResultVariant() const { return system.empty() ? variant : SystemVariant(system); }
  // Throws Error for a job that no plan has.
  void Check(const std::string& where) const;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    CVO_FIELD(sequence)
    CVO_ADDED(family, split, detections)
    CVO_FIELD(variant)
    CVO_ADDED(system)
    CVO_FIELD(seed)
    CVO_ADDED(oracle, parameters, landmarks, folder, missing, frames, content, input, job)
    CVO_ADDED(entry)
    if constexpr (Archive::kReads) self.Check(archive.where());
  }
};

// plan.json: everything that a suite runs.
struct PlanFile {
  static constexpr int kSchemaVersion = 1;
  static constexpr const char* kKind = "plan";

  PlanSuite suite;
  std::string build;
  std::string data;
  PlanTable table;
  Json definition = Json::object();  // the suite file, which workers read
  std::vector<PlanJob> jobs;

  CVO_RECORD(CVO_FIELD(suite, build) CVO_ADDED(data) CVO_FIELD(table) CVO_ADDED(definition)
                 CVO_FIELD(jobs));
};

// failed/<job>.json: why a job has no result.
struct JobFailure {
  static constexpr int kSchemaVersion = 1;
  static constexpr const char* kKind = "failure";

  std::string job;
  std::string message;
  std::string log;  // end of the log

  CVO_RECORD(CVO_ADDED(job, message, log));
};

// Throws Error naming the first thing that the result states differently.
void CheckRunOf(const PlanJob& job, const RunSummary& run);

// A job with the keys of tables: sequence, detections, variant (for another system: its name),
// oracle, and the path of every option that the suite varies.
struct PlannedRun : PlanJob {
  std::map<std::string, std::string> keys;
};

// First column of a suite that measures times, from the timing.json of its runs.
inline constexpr char kFrameCpu[] = "CPU per frame";

// Value of a suite's reference with which each row is compared with the one before it.
inline constexpr std::string_view kRowAbove = "the row above";

struct SuitePlan : PlanTable {
  std::filesystem::path file;
  std::string name;
  std::string about;
  std::vector<PlannedRun> runs;
};

// Throws Error naming the file and the field for an incomplete file, another schema, or a plan
// without jobs.
SuitePlan ReadPlan(const std::filesystem::path& plan_file);

// Outcome of a job. Its state is "ok", "lost", "failed", "not run" or "no data".
struct SuiteRun {
  PlannedRun planned;
  std::string state;
  std::string message;
  std::string log;
  std::optional<RunSummary> run;  // of states "ok" and "lost"
};

// Reads the results that exist, with these metrics. One that cannot be read is "failed".
std::vector<SuiteRun> ReadRuns(const std::filesystem::path& folder, const SuitePlan& plan,
                               const std::vector<std::string>& metrics);

// Returns the value of a key or of "family"; "default" for an option that the run does not set.
std::string KeyOf(const PlannedRun& run, const std::string& key);

}  // namespace cvo::reports
