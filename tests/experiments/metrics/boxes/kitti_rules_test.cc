// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "experiments/metrics/boxes/tracking_scores.h"

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

TEST(KittiTrackingRules, ATrackHasOneBoxPerFrame) {
  EXPECT_THROW(Counted({}, {Box("Car", 1, 0), Box("Car", 1, 100)}), Error);
}

// A box of half the width has an IoU of exactly 1/2.
TEST(KittiTrackingRules, AnIouOfOneHalfIsAMatch) {
  ObjectBox van = Box("Van", 1, 0);
  van.right_px = 100.0;
  EXPECT_TRUE(Counted({van}, {Box("Car", 1, 0)}).estimate.empty());
  van.right_px = 100.1;
  EXPECT_EQ(Counted({van}, {Box("Car", 1, 0)}).estimate.size(), 1U);
  ObjectBox hidden = Box("Car", 1, 0);
  hidden.occlusion = 3;
  EXPECT_TRUE(Counted({hidden}, {Box("Car", 1, 10)}).estimate.empty());
  EXPECT_EQ(Counted({hidden}, {Box("Car", 1, 30)}).estimate.size(), 1U);
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
