// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/boxes/tracking_scores.h"

#include <gtest/gtest.h>

#include <cmath>

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

// Two bodies side by side with overlapping boxes: the alignment score of a pair is reduced by the
// overlap of its boxes with others.
TEST(TrackingScores, CrowdedTracksStayApart) {
  TrackedSequence sequence;
  sequence.truth_count = 2;
  sequence.estimate_count = 2;
  for (int k = 0; k < 3; ++k) {
    sequence.frames.push_back(
        TrackedFrame{{1, 0}, {0, 1}, Eigen::MatrixXd{{0.4, 0.92}, {0.92, 0.3}}});
  }
  const HotaScores hota = EvaluateHota(sequence);
  EXPECT_NEAR(hota.hota, 18.0 / 19.0, 1e-12);
  EXPECT_NEAR(hota.ass_a, 18.0 / 19.0, 1e-12);
  EXPECT_NEAR(hota.loc_a, (18 * 0.92 + 1.0) / 19.0, 1e-12);
  const ClearScores clear = EvaluateClear(sequence);
  EXPECT_EQ(clear.matches, 6);
  EXPECT_EQ(clear.switches, 0);
  EXPECT_EQ(clear.fragments, 0);
  EXPECT_DOUBLE_EQ(EvaluateIdentities(sequence).idf1, 1.0);
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

TEST(TrackingScores, ASingleBox) {
  const IdentityScores identities = EvaluateIdentities(OneBody({0}));
  EXPECT_DOUBLE_EQ(identities.recall, 1.0);
  EXPECT_DOUBLE_EQ(identities.precision, 1.0);
  EXPECT_DOUBLE_EQ(identities.idf1, 1.0);
  const HotaScores hota = EvaluateHota(OneBody({0}));
  EXPECT_DOUBLE_EQ(hota.det_a, 1.0);
  EXPECT_DOUBLE_EQ(hota.ass_a, 1.0);
}

TEST(TrackingScores, EverySwitchCounts) {
  const ClearScores clear = EvaluateClear(OneBody({0, 1, -1, 0, 0}));
  EXPECT_EQ(clear.switches, 2) << "also across a gap";
  EXPECT_EQ(clear.fragments, 0) << "a frame without any report ends no piece, as in TrackEval";
  EXPECT_EQ(clear.missed, 1);
  EXPECT_DOUBLE_EQ(clear.mota, 1.0 - 3.0 / 5.0);
  EXPECT_DOUBLE_EQ(EvaluateHota(OneBody({0, 1, -1, 0, 0})).det_a, 0.8);
}

TEST(TrackingScores, AnEmptyFrameEndsNoPiece) {
  TrackedSequence sequence = OneBody({0, 0, 0});
  sequence.frames[1] = TrackedFrame{{}, {}, Eigen::MatrixXd(0, 0)};
  EXPECT_EQ(EvaluateClear(sequence).fragments, 0);
  EXPECT_DOUBLE_EQ(EvaluateClear(sequence).mota, 1.0);
}

TEST(TrackingScores, ReportsWithoutAnyTruth) {
  TrackedSequence sequence;
  sequence.estimate_count = 2;
  sequence.frames = {TrackedFrame{{}, {0, 1}, Eigen::MatrixXd(0, 2)}};
  const ClearScores clear = EvaluateClear(sequence);
  EXPECT_EQ(clear.false_boxes, 2);
  EXPECT_DOUBLE_EQ(clear.mota, -2.0) << "of one true box at least";
  EXPECT_EQ(clear.motp, 0.0);
  EXPECT_EQ(EvaluateIdentities(sequence).precision, 0.0);
  const HotaScores hota = EvaluateHota(sequence);
  EXPECT_EQ(hota.det_a, 0.0);
  EXPECT_DOUBLE_EQ(hota.loc_a, 1.0) << "nothing is in the wrong place";
}

}  // namespace
}  // namespace cvo::tracking_scores_test
