// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

// Options for tracking the camera against the static scene, and for recovery when it is lost.
struct TrackingOptions {
  // Maximum descriptor distance without a prediction (METHOD.md 3.3).
  static constexpr int kRecoveryHamming = 60;
  // Maximum ratio of the best to the second best distance without a prediction (METHOD.md 3.3).
  static constexpr double kRecoveryRatio = 0.8;
  // RANSAC hypotheses: with 30 % inliers, 300 succeed with probability 99.97 % (1 - (1 -
  // 0.3^3)^300).
  static constexpr int kRecoveryIterations = 300;
  // Number of most recent frames whose landmarks are searched without a prediction; more cost
  // time and give more false matches (a lost frame shows what the frames before it showed; not
  // swept).
  static constexpr int kRecoveryFrames = 5;
  int min_inliers = 15;
  int restart_after = 5;
  double min_disparity_px = 1.0;
  bool align_patches = true;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("min_inliers", self.min_inliers,
                {"landmarks", 4, 1000,
                 "minimum inlier landmarks of a camera pose; with fewer the frame is lost",
                 "well above what chance matches reach"});
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

// Options for the life cycle of clusters: birth, survival and prediction.
struct ClusterOptions {
  int min_landmarks = 8;
  double box_half_size = 0.13;
  int confirm_detections = 2;
  int confirm_frames = 5;
  int undetected_frames = 15;
  int min_tracked = 4;
  int live_frames = 45;
  int max_landmarks = 800;
  double max_past_observations = 30.0;
  // Factor on a cluster's score per frame without a detection (METHOD.md 10.1).
  static constexpr double kScoreDecay = 0.9;
  int trace_states = 3;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("min_landmarks", self.min_landmarks,
                {"landmarks", 3, 1000,
                 "minimum landmarks of a new cluster; fewer detects small and distant bodies, but "
                 "also false ones",
                 "METHOD.md 6.1: 12 indoors, 8 for cars; one value for both"});
    visit.Field(
        "box_half_size", self.box_half_size,
        {"1", 0, 1,
         "minimum half size of a cluster, as a fraction of the mean side of its box: its landmarks "
         "may so far all be on one part",
         "half of (p70 - p30) / 2 of a body that fills its box is 0.2; less, as it rarely does"});
    visit.Field("confirm_detections", self.confirm_detections,
                {"detections", 1, 100,
                 "minimum detections of a cluster to be reported; a single one is often false",
                 "the detectors' false positives rarely repeat"});
    visit.Field("confirm_frames", self.confirm_frames,
                {"frames", 1, 1000, "frames after which an unconfirmed cluster is removed",
                 "spans the detectors' usual gaps of one to four frames"});
    visit.Field("undetected_frames", self.undetected_frames,
                {"frames", 0, 1000,
                 "least number of frames without a detection after which a cluster that stands "
                 "still is removed; 0: never",
                 "METHOD.md 6.4"});
    visit.Field(
        "min_tracked", self.min_tracked,
        {"landmarks", 3, 1000,
         "minimum consistent landmarks to estimate a cluster's pose; with fewer it is predicted",
         "three fix the pose, the fourth checks it"});
    visit.Field("live_frames", self.live_frames,
                {"frames", 0, 1000,
                 "number of frames L after which an unobserved cluster is removed; until then it "
                 "is predicted; 0: window.temporal, as in the paper (section 4.1)",
                 "METHOD.md 6.4: spans an occlusion of one second at 30 Hz"});
    visit.Field("max_landmarks", self.max_landmarks,
                {"landmarks", 10, 100000,
                 "maximum landmarks of one cluster; those unseen for longest are removed first",
                 "bounds time and memory"});
    visit.Field("max_past_observations", self.max_past_observations,
                {"observations", 0, 1e6,
                 "maximum weight of observations that left the window, in observations per "
                 "landmark; larger drifts less and corrects errors more slowly; 0 forgets them",
                 "fixed poses have errors too"});
    visit.Field("trace_states", self.trace_states,
                {"states", 0, 1000,
                 "number of consecutive states after which a new cluster is also searched for in "
                 "earlier frames; 0: never",
                 "two states give a velocity, the third checks it"});
  }
};

}  // namespace cvo
