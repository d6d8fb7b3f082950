// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

// Options for tracking the camera against the static scene, and for recovery when it is lost.
struct TrackingOptions {
  int min_inliers = 15;
  int recovery_hamming = 60;
  double recovery_ratio = 0.8;
  int recovery_iterations = 300;
  int recovery_frames = 5;
  int restart_after = 5;
  double min_disparity_px = 1.0;
  bool align_patches = true;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("min_inliers", self.min_inliers,
                {"landmarks", 4, 1000,
                 "minimum inlier landmarks of a camera pose; with fewer the frame is lost",
                 "well above what chance matches reach"});
    visit.Field(
        "recovery_hamming", self.recovery_hamming,
        {"bits", 1, 256, "maximum descriptor distance without a prediction", "METHOD.md 3.3"});
    visit.Field("recovery_ratio", self.recovery_ratio,
                {"1", 0.1, 1.0,
                 "maximum ratio of the best to the second best distance without a prediction",
                 "METHOD.md 3.3"});
    visit.Field("recovery_iterations", self.recovery_iterations,
                {"1", 1, 100000,
                 "RANSAC hypotheses: with 30 % inliers, 300 succeed with probability 99.97 %",
                 "1 - (1 - 0.3^3)^300"});
    visit.Field("recovery_frames", self.recovery_frames,
                {"frames", 1, 1000,
                 "number of most recent frames whose landmarks are searched without a prediction; "
                 "more cost time and give more false matches",
                 "a lost frame shows what the frames before it showed; not swept"});
    visit.Field("restart_after", self.restart_after,
                {"frames", 1, 1000,
                 "lost frames after which the map is restarted at the predicted camera pose",
                 "half a second at 10 Hz"});
    visit.Field("min_disparity_px", self.min_disparity_px,
                {"px", 0.01, 100,
                 "minimum disparity of a new landmark: below it, depth is dominated by noise",
                 "METHOD.md 2.2"});
    visit.Field("align_patches", self.align_patches,
                {"1", 0, 1,
                 "matched features are aligned with the first patch of their landmark; costs time",
                 "METHOD.md 3.4"});
  }
};

}  // namespace cvo
