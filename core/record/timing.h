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

  CVO_FIELDS(median_ms, mean_ms, p95_ms, total_ms);
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

  CVO_RECORD(CVO_FIELD(sequence, output)
                 CVO_OPTIONAL(labels, detections, detections_camera, min_score));
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

  CVO_FIELDS(job, date, host, cpu, cpus, threads, paths, peak_memory_mb, wall_s, frames_per_second,
             stages, frames);
};

}  // namespace cvo::reports
