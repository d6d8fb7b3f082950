// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/body_rows.h"

#include "reports/results/body_row.h"

namespace cvo {
namespace {

reports::FrameErrors ErrorsOf(const std::vector<ObjectFrameError>& errors) {
  reports::FrameErrors list;
  for (const ObjectFrameError& error : errors) {
    list.frames.push_back(error.frame);
    list.position_m.push_back(error.position_m);
  }
  return list;
}

void SetRelative(const std::optional<RelativeErrors>& errors, std::optional<double>& rotation_rad,
                 std::optional<double>& translation_m) {
  if (!errors) return;
  rotation_rad = errors->rotation_rad;
  translation_m = errors->translation_m;
}

reports::BodyRow RowOf(const BodyScore& score) {
  reports::BodyRow row;
  row.id = score.id;
  row.name = score.name;
  row.category = score.category;
  row.mover = score.mover;
  row.travel_m = score.travel_m;
  row.cluster = score.cluster;
  row.visible_frames = score.visible_frames;
  row.estimated_frames = score.estimated_frames;
  row.id_switches = score.continuity.id_switches;
  row.fragments = score.continuity.fragments;
  row.ate_m = score.ate_m;
  row.predicted_ate_m = score.predicted_ate_m;
  row.velocity_m_s = score.velocity_m_s;
  SetRelative(score.all_pairs, row.all_pairs_rad, row.all_pairs_m);
  SetRelative(score.one_frame, row.one_frame_rad, row.one_frame_m);
  SetRelative(score.motion, row.motion_rad, row.motion_m);
  row.errors = ErrorsOf(score.errors);
  row.predicted = ErrorsOf(score.predicted);
  return row;
}

}  // namespace

std::vector<reports::BodyRow> BodyRows(const std::vector<BodyScore>& bodies) {
  std::vector<reports::BodyRow> rows;
  for (const BodyScore& score : bodies) rows.push_back(RowOf(score));
  return rows;
}

}  // namespace cvo
