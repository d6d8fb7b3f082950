// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests how boxes of a file become detections for the estimator.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "experiments/runner/frame_detections.h"

namespace cvo::detections_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

// 100 x 80 px, f = 100 px, baseline 0.5 m: depth 50 m / disparity.
BoxCamera Camera(double offset_m = 0.0) { return {{100, 100, 50, 40, 0.5, 100, 80}, offset_m}; }

ObjectBox Box(double left, double top, double right, double bottom, std::string type = "Car") {
  ObjectBox box;
  box.type = std::move(type);
  box.left_px = left;
  box.top_px = top;
  box.right_px = right;
  box.bottom_px = bottom;
  return box;
}

StereoFeature FeatureAt(double u_px, double v_px, double depth_m) {
  StereoFeature feature;
  feature.z_px = {u_px, v_px, u_px - 50.0 / depth_m};
  return feature;
}

std::vector<Detection> Given(const std::vector<ObjectBox>& boxes, DetectionCounts& counts,
                             const std::vector<std::string>& classes = RigidClasses()) {
  return DetectionsOfFrame(boxes, Camera(), {}, classes, counts);
}

TEST(Detections, OfOtherClassesAreLeftOutAndCounted) {
  DetectionCounts counts;
  const auto detections =
      Given({Box(10, 10, 20, 20, "car"), Box(10, 10, 20, 20, "Pedestrian"),
             Box(0, 0, 5, 5, "DontCare"), Box(1, 2, 3, 4, "VAN"), Box(9, 9, 9, 9, "DontCare")},
            counts);
  ASSERT_THAT(detections, SizeIs(2));
  EXPECT_EQ(detections[0].category, "car");
  EXPECT_EQ(detections[1].category, "VAN");
  EXPECT_EQ(counts.given, 2);
  EXPECT_THAT(counts.other_classes, ElementsAre(Pair("DontCare", 2), Pair("Pedestrian", 1)));
}

TEST(Detections, ClassesAreThoseRequested) {
  DetectionCounts counts;
  EXPECT_THAT(
      Given({Box(1, 1, 2, 2, "Car"), Box(1, 1, 2, 2, "Dog")}, counts, ParseClasses("dog,cat")),
      SizeIs(1));
  EXPECT_THAT(ParseClasses("Car,Van"), ElementsAre("Car", "Van"));
  for (const char* bad : {"", ",", "Car,", "Car,,Van", "Car, Van"}) {
    EXPECT_THROW(ParseClasses(bad), Error) << bad;
  }
}

TEST(Detections, AreClippedToTheImageAndLeftOutIfOutside) {
  DetectionCounts counts;
  const auto detections = Given({Box(-5, -6, 120, 90), Box(-9, 10, -1, 20), Box(100, 10, 110, 20),
                                 Box(10, 79.5, 20, 95), Box(99, 79, 150, 100)},
                                counts);
  ASSERT_THAT(detections, SizeIs(2));
  EXPECT_EQ(detections[0].box.left_px, 0.0);
  EXPECT_EQ(detections[0].box.top_px, 0.0);
  EXPECT_EQ(detections[0].box.right_px, 99.0);
  EXPECT_EQ(detections[0].box.bottom_px, 79.0);
  EXPECT_EQ(detections[1].box.left_px, detections[1].box.right_px);  // one pixel
  EXPECT_EQ(counts.outside, 3);
}

TEST(Detections, KeepTheirScoreAndLabelsScoreOne) {
  DetectionCounts counts;
  ObjectBox scored = Box(1, 1, 2, 2);
  scored.score = -0.25;
  const auto detections = Given({scored, Box(1, 1, 2, 2)}, counts);
  EXPECT_EQ(detections[0].score, -0.25);
  EXPECT_EQ(detections[1].score, 1.0);
}

TEST(Detections, MayBeNoneOrFiveHundred) {
  DetectionCounts counts;
  EXPECT_THAT(Given({}, counts), IsEmpty());
  EXPECT_THAT(Given(std::vector<ObjectBox>(500, Box(1, 1, 20, 20)), counts), SizeIs(500));
}

TEST(Detections, MoveByTheDisparityOfTheirFeatures) {
  // Boxes are drawn for a camera 0.1 m to the right of the one read, which sees a point at 5 m 2 px
  // further left: p_in_drawn = p_in_read + (offset_m, 0, 0).
  const BoxCamera camera = Camera(-0.1);
  std::vector<StereoFeature> features;
  for (int i = 0; i < 6; ++i) features.push_back(FeatureAt(32.5 + i, 30, 5.0));
  DetectionCounts counts;
  const auto detections =
      DetectionsOfFrame({Box(30, 20, 36, 40)}, camera, features, RigidClasses(), counts);
  ASSERT_THAT(detections, SizeIs(1));
  // In the drawn image, the features are at u - 2: all six are inside the box, which moves by +2.
  EXPECT_NEAR(detections[0].box.left_px, 32.0, 1e-9);
  EXPECT_NEAR(detections[0].box.right_px, 38.0, 1e-9);
  EXPECT_EQ(counts.without_depth, 0);
}

TEST(Detections, EdgesAtTheBorderStayThere) {
  const BoxCamera camera = Camera(-0.1);
  std::vector<StereoFeature> features;
  for (const int u : {2, 92}) {
    for (int i = 0; i < 6; ++i) features.push_back(FeatureAt(u + i, 30, 5.0));
  }
  DetectionCounts counts;
  const auto detections = DetectionsOfFrame({Box(0, 20, 6, 40), Box(88, 20, 99, 40)}, camera,
                                            features, RigidClasses(), counts);
  ASSERT_THAT(detections, SizeIs(2));
  EXPECT_EQ(detections[0].box.left_px, 0.0);
  EXPECT_NEAR(detections[0].box.right_px, 8.0, 1e-9);
  EXPECT_NEAR(detections[1].box.left_px, 90.0, 1e-9);
  EXPECT_EQ(detections[1].box.right_px, 99.0);
}

TEST(Detections, WithoutFeaturesStayWhereTheyWereDrawn) {
  DetectionCounts counts;
  const auto detections = DetectionsOfFrame({Box(30, 20, 36, 40)}, Camera(0.1),
                                            {FeatureAt(33, 30, 5)}, RigidClasses(), counts);
  EXPECT_EQ(detections[0].box.left_px, 30.0);
  EXPECT_EQ(counts.without_depth, 1);
  EXPECT_EQ(counts.given, 1);
}

TEST(DepthInBox, IsOfTheNearestDenseMode) {
  std::vector<StereoFeature> features = {FeatureAt(30, 30, 1.0)};  // one wrong match in front
  for (int i = 0; i < 6; ++i) features.push_back(FeatureAt(30 + i, 30, 10.0 + 0.1 * i));
  for (int i = 0; i < 10; ++i) features.push_back(FeatureAt(30 + i, 32, 40.0 + 0.1 * i));
  const ObjectBox box = Box(25, 25, 45, 45);
  const double depth_m = DepthInBox(box, Camera(), features);
  EXPECT_GE(depth_m, 10.0);
  EXPECT_LE(depth_m, 10.5);
  std::reverse(features.begin(), features.end());
  EXPECT_EQ(DepthInBox(box, Camera(), features), depth_m);
}

TEST(DepthInBox, LooksUpFeaturesInTheImageOfTheBox) {
  // At 2.5 m the disparity is 20 px: in an image 0.5 m to the left of the one read, the features
  // are 20 px further right.
  std::vector<StereoFeature> features;
  for (int i = 0; i < 5; ++i) features.push_back(FeatureAt(30 + i, 30, 2.5));
  EXPECT_EQ(DepthInBox(Box(29, 29, 35, 31), Camera(0.5), features), 0.0);
  EXPECT_NEAR(DepthInBox(Box(49, 29, 55, 31), Camera(0.5), features), 2.5, 1e-9);
}

}  // namespace
}  // namespace cvo::detections_test
