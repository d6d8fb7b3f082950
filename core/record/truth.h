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

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("frames", self.frames);
    archive.Field("poses", self.poses);
    archive.Field("visible", self.visible);
  }
};

struct FramePositions {
  std::vector<int> frames;
  std::vector<Position> positions_m;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("frames", self.frames);
    archive.Field("positions_m", self.positions_m);
  }
};

struct JudgedBody {
  int id = 0;
  std::string name;
  std::string category;
  bool mover = false;
  double diagonal_m = 0.0;    // of its box
  std::int64_t cluster = -1;  // cluster whose poses are scored; -1: none

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("id", self.id);
    archive.Field("name", self.name);
    archive.Field("category", self.category);
    archive.Field("mover", self.mover);
    archive.Field("diagonal_m", self.diagonal_m);
    archive.Field("cluster", self.cluster);
  }
};

struct TruthOfBody : JudgedBody {
  TruthPoses truth;
  FramePositions estimated;  // positions from which its ATE is computed
  FramePositions predicted;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    JudgedBody::VisitFields(self, archive);
    archive.Field("truth", self.truth);
    archive.Field("estimated", self.estimated);
    archive.Field("predicted", self.predicted);
  }
};

// truth.json: the truth of a run in the world frame of the run, which is that of the first left
// camera as estimated. Frames are indices into the frames run.
struct TruthData {
  static constexpr int kSchemaVersion = 1;
  static constexpr const char* kKind = "truth";

  std::string job;
  std::vector<std::optional<Pose>> camera;  // by frame; empty: only bodies have truth
  std::vector<TruthOfBody> bodies;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("job", self.job);
    archive.Field("camera", self.camera);
    archive.Field("bodies", self.bodies);
  }
};

}  // namespace cvo::reports
