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

// Options for re-identification: whether a new cluster continues a lost one, and how its object
// frame is aligned with that of the lost cluster.
struct IdentityOptions {
  double gate = 2.0;
  double center_deviation = 0.3;
  double max_spread_m = 1.0;
  double prediction_deviation = 0.3;
  double min_lead = 0.25;
  double size_factor = 1.7;
  int align_boxes = 15;
  int align_interval = 5;
  double point_deviation = 0.08;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("gate", self.gate,
                {"standard deviations", 0, 100,
                 "gate, in standard deviations, for a new cluster to inherit the id of a lost "
                 "cluster of its class; the lost cluster must explain its position and size at "
                 "least as well as one predicted to within identity.max_spread_m does at this many "
                 "standard deviations; larger keeps more identities and confuses more",
                 "chosen from 1.5 ... 3 on the rooms, streets and the crowd"});
    visit.Field("center_deviation", self.center_deviation,
                {"sizes of the body", 1e-3, 10,
                 "standard deviation between the centres of one body estimated from its boxes "
                 "before and after it was lost",
                 "set by hand on the rendered rooms, not swept"});
    visit.Field("max_spread_m", self.max_spread_m,
                {"m", 1e-3, 1000,
                 "maximum standard deviation of a lost cluster's predicted position: bodies turn "
                 "back, and rooms have walls",
                 "the free space of the rendered rooms, not swept"});
    visit.Field(
        "prediction_deviation", self.prediction_deviation,
        {"deviations of the motion", 1e-3, 1e6,
         "standard deviation of a re-found cluster's position about the position that its motion "
         "before and after the loss predicts; larger trusts the boxes, smaller the motion",
         "chosen from 0.3, 0.6 and 1 on development rooms, crowds, benches and streets, "
         "where little but the object ATE of benches changes"});
    visit.Field("min_lead", self.min_lead,
                {"nats", 0, 100,
                 "minimum log-likelihood margin over the second-best candidate; with larger "
                 "values, doubtful clusters keep a new id",
                 "set by hand on the rooms and the crowd, not swept"});
    visit.Field("size_factor", self.size_factor,
                {"1", 1.01, 100,
                 "standard deviation of a body's size between boxes, as a factor: a turning body "
                 "shows another side",
                 "set by hand on the rendered rooms, not swept"});
    visit.Field("align_boxes", self.align_boxes,
                {"boxes", 1, 10000,
                 "number of boxes up to which a re-found cluster's frame is re-estimated in every "
                 "frame, unless landmarks aligned it earlier",
                 "half a second at 30 Hz, not swept"});
    visit.Field(
        "align_interval", self.align_interval,
        {"frames", 1, 1000,
         "frames between searches for landmarks to refine a frame that was aligned by centres",
         "bounds time"});
    visit.Field("point_deviation", self.point_deviation,
                {"sizes of the body", 1e-4, 1,
                 "maximum distance at which landmarks of the old and the new object frame are "
                 "taken for the same point",
                 "set by hand on the rendered rooms, not swept"});
  }
};

// Options for the life cycle of clusters: birth, survival and prediction.
struct ClusterOptions {
  int min_landmarks = 8;
  double birth_depth = 0.33;
  double box_half_size = 0.13;
  int confirm_detections = 2;
  int confirm_frames = 5;
  int undetected_frames = 15;
  int min_tracked = 4;
  int min_observed = 3;
  int settled_states = 3;
  int live_frames = 0;
  int archived = 20;
  int max_landmarks = 800;
  double max_past_observations = 30.0;
  double first_speed_m_s = 5.0;
  double speed_deviation_m_s = 0.2;
  double first_turn_rad_s = 2.0;
  double turn_deviation_rad_s = 0.5;
  double score_decay = 0.9;
  int trace_states = 3;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("min_landmarks", self.min_landmarks,
                {"landmarks", 3, 1000,
                 "minimum landmarks of a new cluster; fewer detects small and distant bodies, but "
                 "also false ones",
                 "METHOD.md 6.1: 12 indoors, 8 for cars; one value for both"});
    visit.Field(
        "birth_depth", self.birth_depth,
        {"1", 0, 2,
         "depth of a new cluster's origin behind the visible surface, as a fraction of the smaller "
         "side of its box, to place it near the body's centre: the surface of a rotating body "
         "moves",
         "exact for a sphere: its visible disk lies 1/3 of the diameter before its centre"});
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
                 "frames without a detection after which a cluster that stands still is archived; "
                 "0: never",
                 "METHOD.md 6.4"});
    visit.Field(
        "min_tracked", self.min_tracked,
        {"landmarks", 3, 1000,
         "minimum consistent landmarks to estimate a cluster's pose; with fewer it is predicted",
         "three fix the pose, the fourth checks it"});
    visit.Field("min_observed", self.min_observed,
                {"landmarks", 3, 1000,
                 "minimum observed landmarks for a cluster with a pose to be reported as tracked, "
                 "not predicted",
                 "METHOD.md 8.1"});
    visit.Field("settled_states", self.settled_states,
                {"states", 1, 1000,
                 "number of states below which a pose is estimated by RANSAC instead of from the "
                 "prediction: without a velocity, the first matches may all be wrong",
                 "two states give a velocity, the third checks it"});
    visit.Field("live_frames", self.live_frames,
                {"frames", 0, 1000,
                 "number of frames L after which an unobserved cluster is archived; until then it "
                 "is predicted; 0: window.temporal",
                 "paper, section 4.1: L = |T_t|"});
    visit.Field("archived", self.archived,
                {"clusters", 0, 1000,
                 "maximum number of archived clusters that can be found again, most recent first",
                 "bounds time and memory"});
    visit.Field("max_landmarks", self.max_landmarks,
                {"landmarks", 10, 100000,
                 "maximum landmarks of one cluster; those unseen for longest are removed first",
                 "bounds time and memory"});
    visit.Field("max_past_observations", self.max_past_observations,
                {"observations", 0, 1e6,
                 "maximum weight of observations that left the window, in observations per "
                 "landmark; larger drifts less and corrects errors more slowly",
                 "fixed poses have errors too"});
    visit.Field("first_speed_m_s", self.first_speed_m_s,
                {"m/s", 0, 1000, "standard deviation of a new cluster's velocity; falls with 1/n^2",
                 "between walking and driving; the search radius is bounded anyway"});
    visit.Field("speed_deviation_m_s", self.speed_deviation_m_s,
                {"m/s", 0, 100, "standard deviation of a tracked cluster's velocity",
                 "residuals of predictions on the indoor scenes"});
    visit.Field("first_turn_rad_s", self.first_turn_rad_s,
                {"rad/s", 0, 100,
                 "standard deviation of a new cluster's angular velocity; falls with 1/n^2",
                 "a rolling ball"});
    visit.Field("turn_deviation_rad_s", self.turn_deviation_rad_s,
                {"rad/s", 0, 100, "standard deviation of a tracked cluster's angular velocity",
                 "residuals of predictions on the indoor scenes"});
    visit.Field(
        "score_decay", self.score_decay,
        {"1", 0, 1, "factor on a cluster's score per frame without a detection", "METHOD.md 10.1"});
    visit.Field("trace_states", self.trace_states,
                {"states", 0, 1000,
                 "number of consecutive states after which a new cluster is also searched for in "
                 "earlier frames; 0: never",
                 "two states give a velocity, the third checks it"});
  }
};

}  // namespace cvo
