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
  std::int64_t cluster = -1;  // that a detection was associated with; -1: none

  bool IsAt(const PixelBox& other) const;  // to the hundredths of a pixel that files have
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
  std::int64_t label = kOutlierLabel;  // a cluster's id, or one of the above
  std::int32_t truth_body = -1;        // 0: the static scene; -1: not known
  bool wrong = false;                  // see MarkWrongLabels
};

// A cluster as one frame's camera sees it: points are in the camera, metres.
struct ClusterShape {
  std::int64_t id = 0;
  std::string category;
  bool predicted = false;  // by the motion model alone
  std::array<Position, 8>
      corners{};  // corner i is at the positive end of axis k where bit k is set
  Position center{};
  Position ahead{};             // its centre kAhead_s later, if it keeps its velocity
  std::vector<Position> trail;  // its centre in the frames before, oldest first
};

inline constexpr double kAhead_s = 0.5;
inline constexpr double kTrail_s = 2.0;

// All that is drawn on one image.
struct OverlayFrame {
  int frame = 0;        // counted in the folder of the sequence
  double time_s = 0.0;  // since the first frame that was run
  std::string status;   // of the camera
  std::string run;      // "full, seed 1"
  bool has_landmarks = false;
  bool has_clusters = false;
  bool has_truth = false;  // of landmarks
  // By id: the id whose colour a cluster has, where that is not its own (AgreeOnColors).
  std::map<std::int64_t, std::int64_t> color_ids;
  std::vector<LandmarkDot> landmarks;
  std::vector<ClusterShape> clusters;
  std::vector<PixelBox> detections;
};

}  // namespace cvo::reports
