// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/tracking/kitti_rules.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace cvo {
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

TEST(KittiTrackingRules, UnmatchedBoxesThatAreForgiven) {
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

}  // namespace
}  // namespace cvo
