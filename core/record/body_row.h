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

  CVO_FIELDS(frames, position_m);
};

// The largest errors over a run, angles as absolute values.
struct MaxDrift {
  double translation_m = 0.0;
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;

  CVO_FIELDS(translation_m, roll_rad, pitch_rad, yaw_rad);
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

  CVO_FIELDS(all_poses, all_motions, first_motions);
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
  int joins = 0;  // times its cluster returns after a gap
  int wrong_joins = 0;
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

  CVO_RECORD(CVO_FIELD(id, name, category, mover, travel_m, cluster, visible_frames,
                       estimated_frames, id_switches, fragments, ate_m, predicted_ate_m,
                       velocity_m_s, all_pairs_rad, all_pairs_m, one_frame_rad, one_frame_m,
                       motion_rad, motion_m)
                 CVO_ADDED(joins, wrong_joins, ate_in_camera_m, motion_in_camera_m)
                     CVO_OPTIONAL(max_drift) CVO_FIELD(errors, predicted));
};

}  // namespace cvo::reports
