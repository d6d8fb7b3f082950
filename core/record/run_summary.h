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

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("name", self.name);
    archive.Field("type", self.type);
    archive.Field("pair", self.pair);
    archive.Field("first_frame", self.first_frame);
    archive.Field("frames", self.frames);
    archive.Field("total_frames", self.total_frames);
  }
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

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Added("width_px", self.width_px);
    archive.Added("height_px", self.height_px);
    archive.Added("fx_px", self.fx_px);
    archive.Added("fy_px", self.fy_px);
    archive.Added("cx_px", self.cx_px);
    archive.Added("cy_px", self.cy_px);
    archive.Added("baseline_m", self.baseline_m);
    archive.Added("right_shift_px", self.right_shift_px);
  }
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

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("name", self.name);
    archive.Field("type", self.type);
    archive.Added("dataset", self.dataset);
    archive.Field("pair", self.pair);
    archive.Added("groundtruth", self.groundtruth);
    archive.Field("first_frame", self.first_frame);
    archive.Field("frames", self.frames);
    archive.Field("total_frames", self.total_frames);
    archive.Added("labels", self.labels);
    archive.Added("detections", self.detections);
    archive.Added("detections_hash", self.detections_hash);
    archive.Added("content", self.content);
    archive.Added("camera", self.camera);
    archive.Optional("perturbation", self.perturbation);
    archive.Optional("warnings", self.warnings);
    archive.Optional("layout", self.layout);
  }
};

struct RunBodies {
  std::vector<BodyRow> refined;
  std::vector<BodyRow> causal;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("refined", self.refined);
    archive.Field("causal", self.causal);
  }
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

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("job", self.job);
    archive.Field("status", self.status);
    archive.Added("message", self.message);
    archive.Field("variant", self.variant);
    archive.Optional("system", self.system);
    archive.Field("seed", self.seed);
    archive.Field("sequence", self.sequence);
    archive.Added("options", self.options);
    archive.Added("given", self.given);
    archive.Optional("detection_counts", self.detection_counts);
    archive.Added("build", self.build);
    archive.Added("metrics", self.metrics);
    archive.Added("bodies", self.bodies);
    archive.Optional("calibration", self.calibration);
  }
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
