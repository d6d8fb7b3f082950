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

// Position errors of a body, frame by frame.
struct FrameErrors {
  std::vector<int> frames;  // ascending
  std::vector<double> position_m;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("frames", self.frames);
    archive.Field("position_m", self.position_m);
  }
};

// The largest errors over a run, angles as absolute values.
struct MaxDrift {
  double translation_m = 0.0;
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("translation_m", self.translation_m);
    archive.Field("roll_rad", self.roll_rad);
    archive.Field("pitch_rad", self.pitch_rad);
    archive.Field("yaw_rad", self.yaw_rad);
  }
};

// Maximum drifts under the alignments of the same names (Alignment in contract.h).
struct MaxDrifts {
  MaxDrift all_poses;
  MaxDrift all_motions;
  MaxDrift first_motions;

  // Returns the values in the order of the metrics that start at kCameraMaxDrift and at
  // kObjectMaxDrift.
  std::array<double, 12> Values() const {
    std::array<double, 12> values{};
    std::size_t at = 0;
    for (const MaxDrift& drift : {all_poses, all_motions, first_motions}) {
      for (const double value :
           {drift.translation_m, drift.roll_rad, drift.pitch_rad, drift.yaw_rad}) {
        values[at++] = value;
      }
    }
    return values;
  }

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("all_poses", self.all_poses);
    archive.Field("all_motions", self.all_motions);
    archive.Field("first_motions", self.first_motions);
  }
};

// The accuracy of a run on one body, as stored in result files. Errors are root mean squares over
// its frames, empty if the frames do not determine one. Frames count from the first one run.
struct BodyRow {
  int id = 0;
  std::string name;
  std::string category;
  bool mover = false;
  double travel_m = 0.0;
  std::int64_t cluster = -1;  // id of the matched cluster; -1: none
  int visible_frames = 0;
  int estimated_frames = 0;  // of the visible frames
  int id_switches = 0;
  int fragments = 0;
  std::optional<double> ate_m;
  std::optional<double> predicted_ate_m;
  std::optional<double> velocity_m_s;
  std::optional<double> all_pairs_rad;
  std::optional<double> all_pairs_m;
  std::optional<double> one_frame_rad;
  std::optional<double> one_frame_m;
  std::optional<double> motion_rad;
  std::optional<double> motion_m;
  std::optional<double> ate_in_camera_m;
  std::optional<double> motion_in_camera_m;
  std::optional<MaxDrifts> max_drift;
  FrameErrors errors;
  FrameErrors predicted;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("id", self.id);
    archive.Field("name", self.name);
    archive.Field("category", self.category);
    archive.Field("mover", self.mover);
    archive.Field("travel_m", self.travel_m);
    archive.Field("cluster", self.cluster);
    archive.Field("visible_frames", self.visible_frames);
    archive.Field("estimated_frames", self.estimated_frames);
    archive.Field("id_switches", self.id_switches);
    archive.Field("fragments", self.fragments);
    archive.Field("ate_m", self.ate_m);
    archive.Field("predicted_ate_m", self.predicted_ate_m);
    archive.Field("velocity_m_s", self.velocity_m_s);
    archive.Field("all_pairs_rad", self.all_pairs_rad);
    archive.Field("all_pairs_m", self.all_pairs_m);
    archive.Field("one_frame_rad", self.one_frame_rad);
    archive.Field("one_frame_m", self.one_frame_m);
    archive.Field("motion_rad", self.motion_rad);
    archive.Field("motion_m", self.motion_m);
    archive.Added("ate_in_camera_m", self.ate_in_camera_m);
    archive.Added("motion_in_camera_m", self.motion_in_camera_m);
    archive.Optional("max_drift", self.max_drift);
    archive.Field("errors", self.errors);
    archive.Field("predicted", self.predicted);
  }
};

}  // namespace cvo::reports
