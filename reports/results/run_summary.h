// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/results/body_row.h"
#include "reports/results/metric_value.h"

namespace cvo::reports {

inline constexpr int kRunSchemaVersion = 3;

struct SequenceInfo {
  std::string name;
  std::string type;
  std::string pair;  // "grey" or "colour"
  int first_frame = 0;
  int frames = 0;
  int total_frames = 0;         // in the folder
  double right_shift_px = 0.0;  // correction of the published calibration; 0: as published
  std::string content;          // hash

  FrameSpan range() const { return {first_frame, first_frame + frames - 1}; }
};

// What a table needs of one result.json.
struct RunSummary {
  std::filesystem::path file;
  std::string job;
  std::string variant;
  std::uint64_t seed = 0;
  std::string status;  // "ok", "lost", "failed"
  std::string message;
  SequenceInfo sequence;
  std::vector<MetricValue> metrics;
  std::vector<BodyRow> refined;
  std::vector<BodyRow> causal;
  std::string options;    // resolved, as JSON text
  std::string build;      // identity
  std::string commit;     // of the build, for people
  std::string cpu_level;  // of the processor that it ran on
};

// With the metrics of these names. Throws Error naming the file and the field, wherever in it:
// another schema version, half-written, not a run, a number that is none.
RunSummary ReadRun(const std::filesystem::path& result_file,
                   const std::vector<std::string>& metrics);

// nullptr where the run has no such metric.
const MetricValue* FindMetric(const RunSummary& run, const std::string& name);

}  // namespace cvo::reports
