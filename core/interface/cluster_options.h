// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

// Life of the clusters: birth, what keeps them alive, how far they are predicted.
struct ClusterOptions {
  int min_landmarks = 8;
  double birth_depth = 0.33;
  double box_half_size = 0.13;
  int confirm_detections = 2;
  int confirm_frames = 5;
  int min_tracked = 4;
  int min_observed = 3;
  int settled_states = 3;
  int live_frames = 15;
  int archived = 20;
  int max_landmarks = 800;
  double max_past_observations = 30.0;
  double first_speed_m_s = 5.0;
  double speed_deviation_m_s = 0.2;
  double first_turn_rad_s = 2.0;
  double turn_deviation_rad_s = 0.5;
  double score_decay = 0.9;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("min_landmarks", self.min_landmarks,
                {"landmarks", 3, 1000,
                 "minimum landmarks of a new cluster; fewer finds small and far bodies, and ghosts",
                 "METHOD.md 6.1: 12 indoors, 8 for cars; one value for both"});
    visit.Field(
        "birth_depth", self.birth_depth,
        {"1", 0, 2,
         "a new cluster's frame lies this share of its box's smaller side behind the "
         "visible surface, near the body's centre: a spinning body's surface swings",
         "exact for a sphere: its visible disk lies 1/3 of the diameter before its centre"});
    visit.Field(
        "box_half_size", self.box_half_size,
        {"1", 0, 1,
         "half sides of a cluster in its box are not less than this share of the box's mean "
         "side: its landmarks so far may all be on one part",
         "half of (p70 - p30) / 2 of a body that fills its box is 0.2; less, as it rarely does"});
    visit.Field("confirm_detections", self.confirm_detections,
                {"detections", 1, 100,
                 "minimum detections of a cluster to be reported; a single one is often false",
                 "the detectors' false positives rarely repeat"});
    visit.Field("confirm_frames", self.confirm_frames,
                {"frames", 1, 1000, "frames after which a cluster that is not confirmed is dropped",
                 "spans the detectors' usual gaps of one to four frames"});
    visit.Field("min_tracked", self.min_tracked,
                {"landmarks", 3, 1000,
                 "minimum consistent landmarks to estimate a pose; with fewer it is predicted",
                 "three fix the pose, the fourth checks it"});
    visit.Field(
        "min_observed", self.min_observed,
        {"landmarks", 3, 1000, "a frame with fewer has no state of the cluster", "METHOD.md 8.1"});
    visit.Field("settled_states", self.settled_states,
                {"states", 1, 1000,
                 "with fewer, a pose is searched for by RANSAC, not from the predicted one: "
                 "without a velocity the first matches may all be wrong",
                 "two states give a velocity, the third checks it"});
    visit.Field(
        "live_frames", self.live_frames,
        {"frames", 1, 1000,
         "frames, L, after which a cluster that is not seen is archived; it is predicted before",
         "paper, section 4.1"});
    visit.Field("archived", self.archived,
                {"clusters", 0, 1000, "archived clusters that can be found again, the latest ones",
                 "bounds time and memory"});
    visit.Field("max_landmarks", self.max_landmarks,
                {"landmarks", 10, 100000, "of one cluster; the longest unseen go first",
                 "bounds time and memory"});
    visit.Field(
        "max_past_observations", self.max_past_observations,
        {"observations", 0, 1e6,
         "limit on the weight of what left the window, in observations per landmark; larger "
         "drifts less and corrects errors more slowly",
         "poses that were held have errors too"});
    visit.Field("first_speed_m_s", self.first_speed_m_s,
                {"m/s", 0, 1000, "standard deviation of a new cluster's velocity; falls with 1/n^2",
                 "between walking and driving; the search radius is bounded anyway"});
    visit.Field("speed_deviation_m_s", self.speed_deviation_m_s,
                {"m/s", 0, 100, "standard deviation of a tracked cluster's velocity",
                 "residuals of predictions on the indoor scenes"});
    visit.Field("first_turn_rad_s", self.first_turn_rad_s,
                {"rad/s", 0, 100, "standard deviation of a new cluster's turn; falls with 1/n^2",
                 "a rolling ball"});
    visit.Field("turn_deviation_rad_s", self.turn_deviation_rad_s,
                {"rad/s", 0, 100, "standard deviation of a tracked cluster's turn",
                 "residuals of predictions on the indoor scenes"});
    visit.Field("score_decay", self.score_decay,
                {"1", 0, 1, "the detection's score falls by this factor per frame without one",
                 "METHOD.md 10.1"});
  }
};

}  // namespace cvo
