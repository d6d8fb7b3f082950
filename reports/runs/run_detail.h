// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/results/timing.h"
#include "reports/results/truth.h"

namespace cvo::reports {

struct CameraFrame {
  int frame = 0;  // counted in the folder of the sequence
  std::int64_t timestamp_ns = 0;
  std::string status;  // "first", "tracked", "recovered", "lost", "skipped"
  Pose world_from_camera{};
  int window_frames = 0;  // in both tracks, this one included
  // Of the spatial track, in frames before this one; oldest first.
  std::vector<int> spatial_ages = {};
  std::optional<Pose> truth = {};  // in truth.json

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("frame", self.frame);
    archive.Field("timestamp_ns", self.timestamp_ns);
    archive.Field("status", self.status);
    archive.Field("refined", self.world_from_camera);
    archive.Optional("window_frames", self.window_frames);
    archive.Optional("spatial_ages", self.spatial_ages);
  }
};

// A cluster in a frame as last estimated: a row of objects.csv.
struct ClusterRow {
  int frame = 0;
  std::int64_t id = 0;
  std::string category;
  bool predicted = false;  // by the motion model alone: hidden, or lost
  Pose world_from_object{};
  Pose object_from_box{};   // upright, x forward, y down
  Position size_m{};        // of the box: length, height, width
  Position velocity_m_s{};  // in world
  int observed_landmarks = 0;
};

struct BodyPosition {
  int frame = 0;  // counted in the folder, as everywhere here
  Position position_m{};
  double error_m = 0.0;  // as object ATE takes it
};

// A body of the truth, and what of the estimate it is held against.
struct BodyDetail {
  int id = 0;
  std::string name;
  std::string category;
  bool mover = false;
  double diagonal_m = 0.0;                  // of its box
  std::int64_t cluster = -1;                // whose poses are scored; -1: none
  std::vector<std::pair<int, Pose>> truth;  // by frame
  std::vector<int> visible;                 // frames in which it is judged
  std::vector<BodyPosition> estimated;      // in these, where the estimate counts
  std::vector<BodyPosition> predicted;
};

struct StageTime {
  std::string stage;
  double median_ms = 0.0;
  double mean_ms = 0.0;
  double p95_ms = 0.0;
};

// What a run's folder tells of it frame by frame. Everything is in one world: the first left camera
// as estimated, to which the truth is brought by the alignment that the object metrics use.
struct RunDetail {
  std::vector<CameraFrame> camera;
  std::vector<ClusterRow> clusters;  // by frame, then id
  std::vector<BodyDetail> bodies;    // empty where bodies have no truth
  std::vector<StageTime> stages;
  double frames_per_second = 0.0;  // 0: not known
  std::string host;
  std::string cpu;
  std::string date;                  // of the run, UTC
  RunPaths paths;                    // what it read, and where
  std::vector<std::string> missing;  // files that are not there or cannot be read, and why
};

// Reads result.json, truth.json, objects.csv and timing.json of a run. Throws Error for result.json
// alone; what else is missing or damaged is listed and left empty.
RunDetail ReadRunDetail(const std::filesystem::path& run_folder);

}  // namespace cvo::reports
