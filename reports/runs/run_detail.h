// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/record/csv_rows.h"
#include "core/record/run_summary.h"
#include "core/record/truth.h"

namespace cvo::reports {

struct CameraFrame {
  int frame = 0;  // number in the folder of the sequence
  std::int64_t timestamp_ns = 0;
  std::string status;  // "first", "tracked", "recovered", "lost", "skipped"
  Pose world_from_camera{};
  std::optional<CalibrationState> calibration = {};  // empty: not estimated
  std::optional<Pose> truth = {};                    // from truth.json

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("frame", self.frame);
    archive.Field("timestamp_ns", self.timestamp_ns);
    archive.Field("status", self.status);
    archive.Field("refined", self.world_from_camera);
    archive.Optional("calibration", self.calibration);
  }
};

inline constexpr std::int64_t kOutlierLabel = -1;
inline constexpr std::int64_t kStaticLabel = 0;

// What reports keep of a row of landmarks.csv.
struct LabelledLandmark {
  float u_px = 0.0F;
  float v_px = 0.0F;
  std::int64_t label = kOutlierLabel;  // id of a cluster, or one of the constants above
  std::int32_t truth_body = -1;        // 0: the static scene; -1: unknown
  bool wrong = false;                  // see MarkWrongLabels
};
using LandmarksByFrame = std::map<int, std::vector<LabelledLandmark>>;

// Which of the two labels of a landmark is read.
enum class LandmarkLabel {
  kCluster,   // its cluster after the frame was processed
  kInferred,  // inferred by the unary and pairwise terms from this frame alone
};

struct BodyPosition {
  int frame = 0;  // number in the folder, as everywhere here
  Position position_m{};
  double error_m = 0.0;  // as object ATE defines it
};

// A body of the truth, with the estimates that are compared with it. All frames are ascending.
struct BodyDetail : JudgedBody {
  std::vector<std::pair<int, Pose>> truth;  // by frame
  std::vector<int> visible;                 // frames in which it is judged
  std::vector<BodyPosition> estimated;      // in visible frames, where the estimate counts
  std::vector<BodyPosition> predicted;
};

// Per-frame data from a run's folder. Everything is in one world frame, that of the first left
// camera as estimated, into which the truth is transformed by the alignment of the object metrics.
struct RunDetail {
  std::vector<CameraFrame> camera;
  std::vector<ObjectRow> clusters;   // by frame, then id
  std::vector<BodyDetail> bodies;    // empty if bodies have no truth
  TimingData timing;                 // without its frames
  std::vector<std::string> missing;  // files that do not exist or cannot be read, and why
};

// Reads result.json, truth.json, objects.csv and timing.json of a run. Throws Error only for
// result.json; any other missing or damaged file is listed and its data left empty.
RunDetail ReadRunDetail(const std::filesystem::path& run_folder);

// Read single files of a run. Each throws Error naming the file, and the field or line, if the file
// is damaged.
std::vector<ObjectRow> ReadObjects(const std::filesystem::path& file);
LandmarksByFrame ReadLandmarks(const std::filesystem::path& file, LandmarkLabel label);

// Times of a suite's runs as texts; values are medians over the runs of a row.
struct SuiteTimes {
  // Header first, rows in the order of the plan.
  std::vector<std::vector<std::string>> table;
  std::vector<std::string> machines;  // distinct processors with their numbers of threads
};

// Reads the times of the finished runs in a suite's output folder; the runs of one family form one
// row. Throws Error if there is no plan, or if no run is finished.
SuiteTimes ReadSuiteTimes(const std::filesystem::path& folder);

}  // namespace cvo::reports
