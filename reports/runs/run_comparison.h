// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/results/run_summary.h"
#include "reports/tables/table.h"

namespace cvo::reports {

struct ComparedRun {
  std::string name;  // unique: the variant, or the folder
  std::string folder;
  std::string variant;
  std::uint64_t seed = 0;
  std::string status;
  int first_frame = 0;
  int frames = 0;
  std::string build;
  std::map<std::string, std::string> options;  // those that are not the same in all runs

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("name", self.name);
    archive.Field("folder", self.folder);
    archive.Field("variant", self.variant);
    archive.Field("seed", self.seed);
    archive.Field("status", self.status);
    archive.Field("first_frame", self.first_frame);
    archive.Field("frames", self.frames);
    archive.Field("build", self.build);
    archive.Field("options", self.options);
  }
};

// A metric as each run has it.
struct ComparedMetric {
  std::string name;
  std::string unit;
  std::vector<std::optional<double>> values;  // by run
  std::string differing;  // the field of its contract that is not the same in all; empty: none

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("name", self.name);
    archive.Field("unit", self.unit);
    archive.Field("values", self.values);
    archive.Optional("differing", self.differing);
  }
};

// A run against the first on what both have: one body's or the camera's frames, or all bodies.
struct PairedComparison {
  std::string run;
  std::string what;    // "camera position", the name of a body, or of a metric
  std::string metric;  // of its kind; of the camera the same over these frames: camera_ate_mean
  std::string unit;
  std::size_t frames = 0;  // that both have; 0: a pairing of bodies
  Difference difference;
  std::string verdict;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("run", self.run);
    archive.Field("what", self.what);
    archive.Field("metric", self.metric);
    archive.Field("unit", self.unit);
    archive.Field("frames", self.frames);
    archive.Field("difference", self.difference);
    archive.Field("verdict", self.verdict);
  }
};

// Runs of one sequence beside each other. Differences are each run's value minus the first one's.
struct RunComparison {
  static constexpr int kSchemaVersion = 1;
  static constexpr const char* kKind = "comparison of runs";

  std::string sequence;
  std::vector<ComparedRun> runs;
  std::vector<ComparedMetric> metrics;
  std::vector<PairedComparison> by_frame;
  std::vector<PairedComparison> by_body;
  std::vector<std::string> notes;  // what is not compared, and why

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("sequence", self.sequence);
    archive.Field("runs", self.runs);
    archive.Field("metrics", self.metrics);
    archive.Field("by_frame", self.by_frame);
    archive.Field("by_body", self.by_body);
    archive.Field("notes", self.notes);
  }
};

// The folders of at least two runs; the first is what the others are held against. Throws Error for
// a folder that holds no run, and for runs of different sequences.
RunComparison CompareRuns(const std::vector<std::filesystem::path>& folders);

// Consecutive frames that are resampled together, because errors of neighbouring frames are alike:
// about as many blocks as each has frames.
std::size_t BlockLength(std::size_t frames);

}  // namespace cvo::reports
