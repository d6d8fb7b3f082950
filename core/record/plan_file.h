// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/files/json/json_record.h"
#include "core/files/text_file.h"

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
  // kRowAbove (suite_runs.h); empty: none.
  std::string reference;

  CVO_RECORD(CVO_FIELD(rows, metrics) CVO_ADDED(reference));
};

// One planned run.
struct PlanJob {
  std::string sequence;
  std::string family;  // family that the scene is drawn from; empty: none
  std::string split;   // of the scene; "given" for recorded images
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
  std::string content;
  std::string input;
  std::string job;          // empty where the sequence is missing
  std::string boxes;        // file written by a detector; empty: none
  std::uint64_t entry = 0;  // index of the sequence in the definition

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("sequence", self.sequence);
    archive.Added("family", self.family);
    archive.Added("split", self.split);
    archive.Added("detections", self.detections);
    archive.Field("variant", self.variant);
    archive.Added("system", self.system);
    archive.Field("seed", self.seed);
    archive.Added("oracle", self.oracle);
    archive.Added("parameters", self.parameters);
    archive.Added("landmarks", self.landmarks);
    archive.Added("folder", self.folder);
    archive.Added("missing", self.missing);
    archive.Added("frames", self.frames);
    archive.Added("content", self.content);
    archive.Added("input", self.input);
    archive.Added("job", self.job);
    archive.Added("boxes", self.boxes);
    archive.Added("entry", self.entry);
    if constexpr (Archive::kReads) {
      if (self.job.empty() && self.missing.empty()) {
        ThrowError(archive.where(), "no job and no reason why", "one of them");
      }
      if (self.job.starts_with('.') || self.job.find('/') != std::string::npos) {
        ThrowError(archive.where() + ", field job", Quoted(self.job), "the name of its folder");
      }
    }
  }
};

// plan.json: everything that a suite runs. The fields are explained in
// experiments/suite/plan/plan.h.
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

}  // namespace cvo::reports
