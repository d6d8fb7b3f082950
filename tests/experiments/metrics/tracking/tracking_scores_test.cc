// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/tracking/tracking_scores.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cvo {
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

// Two halves under two identities: every box is found, and half of its track.
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

// Similarity 0.72: a match at the limits 0.05 to 0.70, which are 14 of 19.
TEST(TrackingScores, LooseBoxes) {
  const HotaScores hota = EvaluateHota(OneBody({0, 0, 0}, 0.72));
  EXPECT_NEAR(hota.hota, 14.0 / 19.0, 1e-12);
  EXPECT_NEAR(hota.loc_a, (14.0 * 0.72 + 5.0) / 19.0, 1e-12);
  EXPECT_DOUBLE_EQ(EvaluateClear(OneBody({0}, 0.5)).motp, 0.5);
  EXPECT_DOUBLE_EQ(EvaluateClear(OneBody({0}, 0.49)).mota, -1.0);
}

// A frame without a report ends a piece; one without true and reported boxes does not.
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

// The pair of the frame before stays, though another is more similar now.
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

TEST(TrackingScores, NothingAtAll) {
  EXPECT_EQ(EvaluateHota({}).hota, 0.0);
  EXPECT_EQ(EvaluateClear({}).mota, 0.0);
  EXPECT_EQ(EvaluateIdentities({}).idf1, 0.0);
}

}  // namespace
}  // namespace cvo
