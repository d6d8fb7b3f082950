// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include "experiments/metrics/boxes/tracking_scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace cvo::tracking_scores_test {
namespace {

// One true body in each frame, reported under the given identity (-1: not reported) with the given
// similarity.
TrackedSequence OneBody(const std::vector<int>& estimates, double similarity = 1.0) {
  TrackedSequence sequence;
  sequence.truth_count = 1;
  for (const int id : estimates) {
    TrackedFrame frame;
    frame.truth = {0};
    frame.similarity.resize(1, id < 0 ? 0 : 1);
    if (id >= 0) {
      frame.estimate = {id};
      frame.similarity(0, 0) = similarity;
      sequence.estimate_count = std::max(sequence.estimate_count, id + 1);
    }
    sequence.frames.push_back(frame);
  }
  return sequence;
}

TEST(TrackingScores, APerfectTrack) {
  const TrackedSequence sequence = OneBody({0, 0, 0, 0});
  const HotaScores hota = EvaluateHota(sequence);
  EXPECT_DOUBLE_EQ(hota.hota, 1.0);
  EXPECT_DOUBLE_EQ(hota.loc_a, 1.0);
  EXPECT_DOUBLE_EQ(EvaluateClear(sequence).mota, 1.0);
  EXPECT_DOUBLE_EQ(EvaluateIdentities(sequence).idf1, 1.0);
}

// Two halves of a track under two identities: every box is found, but with only half of its track.
TEST(TrackingScores, ABrokenTrack) {
  const TrackedSequence sequence = OneBody({0, 0, 1, 1});
  const HotaScores hota = EvaluateHota(sequence);
  EXPECT_DOUBLE_EQ(hota.det_a, 1.0);
  EXPECT_DOUBLE_EQ(hota.ass_a, 0.5);
  EXPECT_NEAR(hota.hota, std::sqrt(0.5), 1e-12);
  const ClearScores clear = EvaluateClear(sequence);
  EXPECT_EQ(clear.switches, 1);
  EXPECT_DOUBLE_EQ(clear.mota, 0.75);
  EXPECT_DOUBLE_EQ(EvaluateIdentities(sequence).idf1, 0.5);
}

// A similarity of 0.72 is a match at the thresholds 0.05 to 0.70, which are 14 of 19.
TEST(TrackingScores, LooseBoxes) {
  const HotaScores hota = EvaluateHota(OneBody({0, 0, 0}, 0.72));
  EXPECT_NEAR(hota.hota, 14.0 / 19.0, 1e-12);
  EXPECT_NEAR(hota.loc_a, (14.0 * 0.72 + 5.0) / 19.0, 1e-12);
  EXPECT_DOUBLE_EQ(EvaluateClear(OneBody({0}, 0.5)).motp, 0.5);
  EXPECT_DOUBLE_EQ(EvaluateClear(OneBody({0}, 0.49)).mota, -1.0);
}

// A frame without a report is a miss, not a switch. One whose report lies elsewhere ends a fragment
// of the track.
TEST(TrackingScores, FragmentsAndMisses) {
  TrackedSequence sequence = OneBody({0, -1, 0, 0});
  ClearScores clear = EvaluateClear(sequence);
  EXPECT_EQ(clear.missed, 1);
  EXPECT_EQ(clear.matches, 3);
  EXPECT_EQ(clear.switches, 0);
  sequence = OneBody({0, 1, 0});
  sequence.frames[1] = OneBody({0}, 0.1).frames[0];  // reported, but elsewhere
  clear = EvaluateClear(sequence);
  EXPECT_EQ(clear.fragments, 1);
  EXPECT_EQ(clear.false_boxes, 1);
}

// The pair of the previous frame is kept although another is more similar now.
TEST(TrackingScores, PairsAreKept) {
  TrackedSequence sequence = OneBody({0, 0});
  sequence.estimate_count = 2;
  sequence.frames[0].similarity(0, 0) = 0.6;
  sequence.frames[1].estimate = {0, 1};
  sequence.frames[1].similarity.resize(1, 2);
  sequence.frames[1].similarity << 0.6, 0.9;
  const ClearScores clear = EvaluateClear(sequence);
  EXPECT_EQ(clear.switches, 0);
  EXPECT_DOUBLE_EQ(clear.motp, 0.6);
  EXPECT_EQ(clear.false_boxes, 1);
}

TEST(TrackingScores, EmptyInputScoresZero) {
  EXPECT_EQ(EvaluateHota({}).hota, 0.0);
  EXPECT_EQ(EvaluateClear({}).mota, 0.0);
  EXPECT_EQ(EvaluateIdentities({}).idf1, 0.0);
}

// One body is missed in the first frame, and a false box is reported in the second.
TEST(TrackingScores, AMissAndAFalseBox) {
  TrackedSequence sequence;
  sequence.truth_count = 2;
  sequence.estimate_count = 2;
  sequence.frames = {TrackedFrame{{0, 1}, {0}, Eigen::Vector2d(1.0, 0.0)},
                     TrackedFrame{{0}, {0, 1}, Eigen::RowVector2d(1.0, 0.0)}};
  const HotaScores hota = EvaluateHota(sequence);
  EXPECT_DOUBLE_EQ(hota.det_a, 0.5);
  EXPECT_DOUBLE_EQ(hota.ass_a, 1.0);
  EXPECT_NEAR(hota.hota, std::sqrt(0.5), 1e-12);
  const ClearScores clear = EvaluateClear(sequence);
  EXPECT_EQ(clear.matches, 2);
  EXPECT_EQ(clear.missed, 1);
  EXPECT_EQ(clear.false_boxes, 1);
  EXPECT_NEAR(clear.mota, 1.0 / 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(clear.motp, 1.0);
  const IdentityScores identities = EvaluateIdentities(sequence);
  EXPECT_NEAR(identities.recall, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(identities.precision, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(identities.idf1, 2.0 / 3.0, 1e-12);
}

// In the last frame, identity 1 is more similar, but identity 0 is that of the track. There are
// three matches at the 12 thresholds up to 0.60, two at the 4 up to 0.80 and none at the last
// three.
TEST(TrackingScores, WholeTracksDecideTheMatching) {
  TrackedSequence sequence;
  sequence.truth_count = 1;
  sequence.estimate_count = 2;
  sequence.frames = {TrackedFrame{{0}, {0}, Eigen::MatrixXd::Constant(1, 1, 0.82)},
                     TrackedFrame{{0}, {0}, Eigen::MatrixXd::Constant(1, 1, 0.82)},
                     TrackedFrame{{0}, {0, 1}, Eigen::RowVector2d(0.62, 0.70)}};
  const HotaScores hota = EvaluateHota(sequence);
  EXPECT_NEAR(hota.det_a, (12 * 0.75 + 4 * 0.4) / 19.0, 1e-12);
  EXPECT_NEAR(hota.ass_a, (12 * 1.0 + 4 * 0.5) / 19.0, 1e-12);
  EXPECT_NEAR(hota.hota, (12 * std::sqrt(0.75) + 4 * std::sqrt(0.2)) / 19.0, 1e-12);
  EXPECT_NEAR(hota.loc_a, (12 * (0.82 + 0.82 + 0.62) / 3.0 + 4 * 0.82 + 3.0) / 19.0, 1e-12);
}

// If a track is reported under several identities, the one with most of its boxes counts.
TEST(TrackingScores, TheIdentityOfMostBoxesCounts) {
  const TrackedSequence sequence = OneBody({0, 1, 1, 1, -1});
  const IdentityScores identities = EvaluateIdentities(sequence);
  EXPECT_DOUBLE_EQ(identities.recall, 3.0 / 5.0);
  EXPECT_DOUBLE_EQ(identities.precision, 3.0 / 4.0);
  EXPECT_DOUBLE_EQ(identities.idf1, 3.0 / 4.5);
  EXPECT_DOUBLE_EQ(EvaluateIdentities(OneBody({0, 0}, 0.5)).idf1, 1.0) << "at the limit";
  EXPECT_DOUBLE_EQ(EvaluateIdentities(OneBody({0, 0}, 0.49)).idf1, 0.0);
}

}  // namespace
}  // namespace cvo::tracking_scores_test

namespace cvo::kitti_rules_test {
namespace {

ObjectBox Box(const std::string& type, int track, double left_px, double height_px = 50.0) {
  ObjectBox box;
  box.type = type;
  box.track = track;
  box.truncation = 0.0;
  box.occlusion = 0;
  box.left_px = left_px;
  box.right_px = left_px + 50.0;
  box.bottom_px = height_px;
  return box;
}

TrackedFrame Counted(const std::vector<ObjectBox>& labels,
                     const std::vector<ObjectBox>& detections) {
  return CountedBoxes({{labels, detections}}, "Car", BoxSpace::kImage).frames.at(0);
}

TEST(KittiTrackingRules, HiddenOrTruncatedLabelsDoNotCount) {
  ObjectBox hidden = Box("Car", 1, 0);
  hidden.occlusion = 3;
  ObjectBox cut = Box("Car", 2, 100);
  cut.truncation = 1.0;
  ObjectBox half = Box("Car", 3, 200);
  half.occlusion = 2;
  const TrackedFrame frame =
      Counted({hidden, cut, half}, {Box("Car", 1, 0), Box("Car", 2, 100), Box("Car", 3, 200)});
  EXPECT_EQ(frame.truth.size(), 1U);
  EXPECT_EQ(frame.estimate.size(), 1U);
  EXPECT_DOUBLE_EQ(frame.similarity(0, 0), 1.0);
}

TEST(KittiTrackingRules, SomeUnmatchedBoxesAreForgiven) {
  EXPECT_TRUE(Counted({}, {Box("Car", 1, 0, 25.0)}).estimate.empty());
  EXPECT_EQ(Counted({}, {Box("Car", 1, 0, 25.1)}).estimate.size(), 1U);
  EXPECT_TRUE(Counted({Box("Van", 1, 0)}, {Box("Car", 1, 0)}).estimate.empty());
  EXPECT_EQ(Counted({Box("Truck", 1, 0)}, {Box("Car", 1, 0)}).estimate.size(), 1U);
  EXPECT_TRUE(Counted({Box("DontCare", -1, 20)}, {Box("Car", 1, 0)}).estimate.empty());
  EXPECT_EQ(Counted({Box("DontCare", -1, 25)}, {Box("Car", 1, 0)}).estimate.size(), 1U);
  EXPECT_TRUE(Counted({}, {Box("Pedestrian", 1, 0)}).estimate.empty());
}

// Each reported box is matched to the labelled box that it lies on, whatever their order.
TEST(KittiTrackingRules, BoxesAreMatchedOneByOne) {
  const TrackedFrame frame =
      Counted({Box("Van", 1, 0), Box("Car", 2, 100), Box("Car", 3, 200)},
              {Box("Car", 7, 205), Box("Car", 8, 100), Box("Car", 9, 0), Box("Car", 4, 400)});
  EXPECT_EQ(frame.truth.size(), 2U);
  ASSERT_EQ(frame.estimate.size(), 3U) << "the one on the van does not count";
  EXPECT_DOUBLE_EQ(frame.similarity(0, 1), 1.0);
  EXPECT_DOUBLE_EQ(frame.similarity(1, 0), 45.0 / 55.0);
  EXPECT_DOUBLE_EQ(frame.similarity(1, 2), 0.0);
}

TEST(KittiTrackingRules, TracksBecomeConsecutiveIdentities) {
  const TrackedSequence sequence =
      CountedBoxes({{{Box("Car", 7, 0), Box("Car", 3, 100)}, {Box("Car", 50, 0)}},
                    {{Box("Car", 3, 100), Box("Car", 9, 300)}, {Box("Car", 60, 0)}}},
                   "Car", BoxSpace::kImage);
  ASSERT_EQ(sequence.frames.size(), 2U);
  EXPECT_EQ(sequence.frames[0].truth, (std::vector<int>{0, 1}));
  EXPECT_EQ(sequence.frames[1].truth, (std::vector<int>{1, 2}));
  EXPECT_EQ(sequence.frames[1].estimate, std::vector<int>{1});
  EXPECT_EQ(sequence.truth_count, 3);
  EXPECT_EQ(sequence.estimate_count, 2);
}

TEST(KittiTrackingRules, ASittingPersonIsANeighbourOfPedestrians) {
  const auto counted = [](const std::string& type) {
    return CountedBoxes({{{Box(type, 1, 0)}, {Box("Pedestrian", 1, 0)}}}, "Pedestrian",
                        BoxSpace::kImage)
        .frames.at(0);
  };
  EXPECT_TRUE(counted("Person_sitting").estimate.empty());
  EXPECT_TRUE(counted("Person").truth.empty());
  EXPECT_EQ(counted("Pedestrian").truth.size(), 1U);
  EXPECT_EQ(counted("Van").estimate.size(), 1U);
}

}  // namespace
}  // namespace cvo::kitti_rules_test
