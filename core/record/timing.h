// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/files/json/json_record.h"

namespace cvo::reports {

struct StageSummary {
  double median_ms = 0.0;
  double mean_ms = 0.0;
  double p95_ms = 0.0;
  double total_ms = 0.0;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("median_ms", self.median_ms);
    archive.Field("mean_ms", self.mean_ms);
    archive.Field("p95_ms", self.p95_ms);
    archive.Field("total_ms", self.total_ms);
  }
};

// Paths of a run's input and output on the machine where it was made, with the settings of the
// input.
struct RunPaths {
  std::string sequence;
  std::string output;
  std::optional<std::string> labels;      // file; empty: those in the folder
  std::optional<std::string> detections;  // file, level of a scene or "labels"
  std::optional<int> detections_camera;   // image_0X; empty: the left image that was read
  std::optional<double> min_score;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("sequence", self.sequence);
    archive.Field("output", self.output);
    archive.Optional("labels", self.labels);
    archive.Optional("detections", self.detections);
    archive.Optional("detections_camera", self.detections_camera);
    archive.Optional("min_score", self.min_score);
  }
};

// timing.json: where and when a run was made, and how long it took.
struct TimingData {
  static constexpr int kSchemaVersion = 1;
  static constexpr const char* kKind = "timing";

  std::string job;
  std::string date;  // UTC, ISO 8601
  std::string host;
  std::string cpu;
  int cpus = 0;
  int threads = 1;
  RunPaths paths;
  double peak_memory_mb = 0.0;  // 10^6 bytes, of the whole process
  double wall_s = 0.0;
  double frames_per_second = 0.0;
  std::map<std::string, StageSummary> stages;
  Json frames = Json::array();  // {frame, <stage>_ms ...}

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("job", self.job);
    archive.Field("date", self.date);
    archive.Field("host", self.host);
    archive.Field("cpu", self.cpu);
    archive.Field("cpus", self.cpus);
    archive.Field("threads", self.threads);
    archive.Field("paths", self.paths);
    archive.Field("peak_memory_mb", self.peak_memory_mb);
    archive.Field("wall_s", self.wall_s);
    archive.Field("frames_per_second", self.frames_per_second);
    archive.Field("stages", self.stages);
    archive.Field("frames", self.frames);
  }
};

}  // namespace cvo::reports
