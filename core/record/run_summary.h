// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/files/json/json_record.h"
#include "core/record/body_row.h"
#include "core/record/contract.h"

namespace cvo::reports {

struct LibraryVersions {
  std::string opencv;
  std::string eigen;

  CVO_RECORD(CVO_ADDED(opencv, eigen));
};

// The build of the program that made a run.
struct BuildInfo {
  std::string version;
  std::string estimator_sources;   // SHA-256 over core, variants and the readers
  std::string evaluation_sources;  // SHA-256 over metrics and runner
  std::string compiler;
  std::string build_type;
  std::string flags;
  LibraryVersions libraries;
  std::string cpu_level;  // CpuLevel of the machine
  std::string identity;   // hash of the fields above
  std::string commit;     // for human readers; with "+changes" if the sources differ from it

  template <typename Self, typename Archive>
  static void VisitIdentity(Self& self, Archive& archive) {
    archive.Added("version", self.version);
    archive.Added("estimator_sources", self.estimator_sources);
    archive.Added("evaluation_sources", self.evaluation_sources);
    archive.Added("compiler", self.compiler);
    archive.Added("build_type", self.build_type);
    archive.Added("flags", self.flags);
    archive.Added("libraries", self.libraries);
    archive.Added("cpu_level", self.cpu_level);
  }

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    VisitIdentity(self, archive);
    archive.Field("identity", self.identity);
    archive.Added("commit", self.commit);
  }

  // Returns what a program of the same sources must match to give the same bytes: compiler, flags,
  // libraries and CPU level. Empty if the run does not state them.
  std::string Platform() const {
    if (compiler.empty() || cpu_level.empty()) return "";
    return StrCat(compiler, ", ", build_type, ", ", flags, ", OpenCV ", libraries.opencv,
                  ", Eigen ", libraries.eigen, ", ", cpu_level);
  }
};

// The estimated calibration error: the coefficients of StereoCamera::right_field_px and their
// standard deviations.
struct CalibrationState {
  std::array<double, 6> right_field_px{};
  std::array<double, 6> sigma_px{};

  CVO_FIELDS(right_field_px, sigma_px);
};

// One value of a run, as stored in result files.
struct MetricValue {
  std::string name;    // name of a form in the catalogue
  double value = 0.0;  // finite
  MetricUnit unit = MetricUnit::kOne;
  std::int64_t n = 0;  // number of errors aggregated
  Contract contract;
  std::string left_out;  // what was left out, with counts; not part of the contract

  CVO_RECORD(CVO_FIELD(name, value, unit, n, contract) CVO_OPTIONAL(left_out));
};

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
  double cpu_s = 0.0;  // of all threads, in wall_s
  double frames_per_second = 0.0;
  std::map<std::string, StageSummary> stages;
  Json frames = Json::array();  // {frame, <stage>_ms ...}

  CVO_RECORD(CVO_FIELD(job, date, host, cpu, cpus, threads, paths, peak_memory_mb, wall_s)
                 CVO_ADDED(cpu_s) CVO_FIELD(frames_per_second, stages, frames));
};

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
  std::string images;   // hash of the images alone, whatever their folder is named; empty: unknown
  CameraInfo camera;
  std::optional<Json> perturbation;   // of images and calibration
  std::vector<std::string> warnings;  // about implausible timestamps and truth
  std::optional<Json> layout;         // settings with which its folder was read

  CVO_RECORD(CVO_FIELD(name, type) CVO_ADDED(dataset) CVO_FIELD(pair) CVO_ADDED(groundtruth)
                 CVO_FIELD(first_frame, frames, total_frames)
                     CVO_ADDED(labels, detections, detections_hash, content, camera)
                         CVO_OPTIONAL(perturbation, warnings, layout, images));
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
  std::string checksum;                         // ChecksumOf; empty in older files

  CVO_RECORD(CVO_FIELD(job, status) CVO_ADDED(message) CVO_FIELD(variant) CVO_OPTIONAL(system)
                 CVO_FIELD(seed, sequence) CVO_ADDED(options, given) CVO_OPTIONAL(detection_counts)
                     CVO_ADDED(build, metrics, bodies) CVO_OPTIONAL(calibration, checksum));
};

// Hash of the fields above but the calibration, which files state in more detail, and itself.
std::string ChecksumOf(RunSummary run);

// What determines the bytes of a result besides its input: two builds with the same hash of all
// fields but the commit give the same results.
std::string IdentityOf(const BuildInfo& build);

// Everything that determines the bytes of a result.
struct Job {
  std::string build;  // BuildInfo::identity
  std::string variant;
  Json options;            // resolved
  std::string content;     // hash of the sequence
  std::string detections;  // RunSequence::detections_hash
  Json given;
  std::uint64_t seed = 0;
};

// Jobs with the same identity have the same result.
std::string JobIdentity(const Job& job);

// Returns the variant name of a run that scores another system's files.
inline std::string SystemVariant(const std::string& system) { return "system:" + system; }

// Reads a result, keeping only the metrics of these names. Throws Error naming the file and the
// field, however deep: another schema version, an incomplete file, not a run, an invalid number, a
// checksum or job that is not that of its content.
RunSummary ReadRun(const std::filesystem::path& result_file,
                   const std::vector<std::string>& metrics);

// Throws Error naming `where` and the metric for a value that no run can have. For an unknown name
// only the magnitude is checked.
void CheckPossible(const std::string& name, double value, const std::string& where);

// Returns nullptr if the run has no such metric.
const MetricValue* FindMetric(const RunSummary& run, const std::string& name);

}  // namespace cvo::reports
