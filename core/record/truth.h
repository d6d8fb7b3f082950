// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json_record.h"

namespace cvo::reports {

using Position = std::array<double, 3>;  // m
using Pose = std::array<double, 7>;      // tx ty tz qx qy qz qw

struct TruthPoses {
  std::vector<int> frames;
  std::vector<Pose> poses;
  std::vector<bool> visible;

  CVO_FIELDS(frames, poses, visible);
};

struct FramePositions {
  std::vector<int> frames;
  std::vector<Position> positions_m;

  CVO_FIELDS(frames, positions_m);
};

struct JudgedBody {
  int id = 0;
  std::string name;
  std::string category;
  bool mover = false;
  double diagonal_m = 0.0;    // of its box
  std::int64_t cluster = -1;  // cluster whose poses are scored; -1: none

  CVO_FIELDS(id, name, category, mover, diagonal_m, cluster);
};

struct TruthOfBody : JudgedBody {
  TruthPoses truth;
  FramePositions estimated;  // positions from which its ATE is computed
  FramePositions predicted;

  CVO_RECORD(JudgedBody::VisitFields(self, archive); CVO_FIELD(truth, estimated, predicted));
};

// truth.json: the truth of a run in the world frame of the run, which is that of the first left
// camera as estimated. Frames are indices into the frames run.
struct TruthData {
  static constexpr int kSchemaVersion = 1;
  static constexpr const char* kKind = "truth";

  std::string job;
  std::vector<std::optional<Pose>> camera;  // by frame; empty: only bodies have truth
  std::vector<TruthOfBody> bodies;

  CVO_FIELDS(job, camera, bodies);
};

}  // namespace cvo::reports
