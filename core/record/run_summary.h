// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/record/body_row.h"
#include "core/record/build_info.h"
#include "core/record/calibration_state.h"
#include "core/record/metric_value.h"

namespace cvo::reports {

struct SequenceInfo {
  std::string name;
  std::string type;
  std::string pair;  // "grey" or "colour"
  int first_frame = 0;
  int frames = 0;
  int total_frames = 0;  // number in the folder

  FrameSpan range() const { return {first_frame, first_frame + frames - 1}; }

  CVO_FIELDS(name, type, pair, first_frame, frames, total_frames);
};

struct CameraInfo {
  int width_px = 0;
  int height_px = 0;
  double fx_px = 0.0;
  double fy_px = 0.0;
  double cx_px = 0.0;
  double cy_px = 0.0;
  double baseline_m = 0.0;
  double right_shift_px = 0.0;  // correction of the published calibration; 0: as published

  CVO_RECORD(CVO_ADDED(width_px, height_px, fx_px, fy_px, cx_px, cy_px, baseline_m,
                       right_shift_px));
};

// The sequence as it was read.
struct RunSequence : SequenceInfo {
  std::string dataset;
  std::string groundtruth;
  std::uint64_t labels = 0;
  std::uint64_t detections = 0;
  std::string detections_hash;
  std::string content;  // hash
  CameraInfo camera;
  std::optional<Json> perturbation;   // of images and calibration
  std::vector<std::string> warnings;  // about implausible timestamps and truth
  std::optional<Json> layout;         // settings with which its folder was read

  CVO_RECORD(CVO_FIELD(name, type) CVO_ADDED(dataset) CVO_FIELD(pair) CVO_ADDED(groundtruth)
                 CVO_FIELD(first_frame, frames, total_frames)
                     CVO_ADDED(labels, detections, detections_hash, content, camera)
                         CVO_OPTIONAL(perturbation, warnings, layout));
};

struct RunBodies {
  std::vector<BodyRow> refined;
  std::vector<BodyRow> causal;

  CVO_FIELDS(refined, causal);
};

// result.json without its data on single frames and clusters.
struct RunSummary {
  static constexpr int kSchemaVersion = 3;
  static constexpr const char* kKind = "run";

  std::filesystem::path file;  // result.json
  std::string job;
  std::string status;  // "ok", "lost", "failed"
  std::string message;
  std::string variant;
  std::optional<Json> system;  // files of another system, if the run scores these
  std::uint64_t seed = 0;
  RunSequence sequence;
  Json options = Json::object();  // resolved
  Json given = Json::object();    // classes and oracles
  std::optional<Json> detection_counts;
  BuildInfo build;
  std::vector<MetricValue> metrics;
  std::optional<RunBodies> bodies;              // empty without truth
  std::optional<CalibrationState> calibration;  // at the end; empty if it was not estimated

  CVO_RECORD(CVO_FIELD(job, status) CVO_ADDED(message) CVO_FIELD(variant) CVO_OPTIONAL(system)
                 CVO_FIELD(seed, sequence) CVO_ADDED(options, given) CVO_OPTIONAL(detection_counts)
                     CVO_ADDED(build, metrics, bodies) CVO_OPTIONAL(calibration));
};

// Returns the variant name of a run that scores another system's files.
inline std::string SystemVariant(const std::string& system) { return "system:" + system; }

// What a plan states about the result of a job. `content` is empty if it is not stated.
struct ExpectedRun {
  std::string job;
  std::string variant;
  std::uint64_t seed = 0;
  std::string content;
  std::vector<std::string> oracle;
  Json parameters = Json::object();  // value by dotted path; only options are compared
};

// Throws Error naming the first thing that the result states differently.
void CheckRunOf(const ExpectedRun& expected, const RunSummary& run);

// Reads a result, keeping only the metrics of these names. Throws Error naming the file and the
// field, however deep: another schema version, an incomplete file, not a run, an invalid number.
RunSummary ReadRun(const std::filesystem::path& result_file,
                   const std::vector<std::string>& metrics);

// Returns nullptr if the run has no such metric.
const MetricValue* FindMetric(const RunSummary& run, const std::string& name);

}  // namespace cvo::reports
