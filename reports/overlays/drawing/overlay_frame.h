// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "reports/results/run_summary.h"
#include "reports/runs/run_detail.h"

namespace cvo::reports {

struct PixelBox {
  double left_px = 0.0;
  double top_px = 0.0;
  double right_px = 0.0;
  double bottom_px = 0.0;
  std::int64_t cluster = -1;  // that the detection was associated with; -1: none

  bool IsAt(const PixelBox& other) const;  // within 0.02 px: files are rounded to 0.01 px
};

inline bool PixelBox::IsAt(const PixelBox& other) const {
  constexpr double kTolerance_px = 0.02;
  const auto same = [](double a, double b) { return std::abs(a - b) < kTolerance_px; };
  return same(left_px, other.left_px) && same(top_px, other.top_px) &&
         same(right_px, other.right_px) && same(bottom_px, other.bottom_px);
}

inline constexpr std::int64_t kOutlierLabel = -1;
inline constexpr std::int64_t kStaticLabel = 0;

struct LandmarkDot {
  float u_px = 0.0F;
  float v_px = 0.0F;
  std::int64_t label = kOutlierLabel;  // id of a cluster, or one of the constants above
  std::int32_t truth_body = -1;        // 0: the static scene; -1: unknown
  bool wrong = false;                  // see MarkWrongLabels
};

// A cluster as seen in one frame. Points are in the camera frame, in metres.
struct ClusterShape {
  std::int64_t id = 0;
  std::string category;
  bool predicted = false;  // by the motion model alone
  // Corner i is at the positive end of axis k if bit k of i is set.
  std::array<Position, 8> corners{};
  Position center{};
  Position ahead{};             // its centre kAhead_s later, at constant velocity
  std::vector<Position> trail;  // its centre in the preceding frames, oldest first
};

inline constexpr double kAhead_s = 0.5;
inline constexpr double kTrail_s = 2.0;

// Everything that is drawn on one image.
struct OverlayFrame {
  int frame = 0;        // index within the folder of the sequence
  double time_s = 0.0;  // since the first frame of the run
  std::string status;   // tracking status of the camera
  std::string run;      // "full, seed 1"
  bool has_landmarks = false;
  bool has_clusters = false;
  bool has_truth = false;  // the true bodies of landmarks are known
  // By cluster id: the id whose colour the cluster takes, if that is not its own (ApartColors,
  // AgreeOnColors).
  std::map<std::int64_t, std::int64_t> color_ids;
  std::vector<LandmarkDot> landmarks;
  std::vector<ClusterShape> clusters;
  std::vector<PixelBox> detections;
};

}  // namespace cvo::reports
