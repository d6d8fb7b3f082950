// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "experiments/runner/frame_source.h"
#include "experiments/runner/given.h"
#include "tests/support/real_data.h"

namespace cvo::detections_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

// Tests how boxes of a file become detections for the estimator.

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

// Tests that boxes drawn in image_02 of a real drive move to image_00 by the depth of their
// features.

// Both moving cars of drive_0013 are seen from behind: the visible face is half a length nearer
// than the centre of the labelled box.
TEST(KittiDetections, MoveByTheDepthOfTheNearFace) {
  const auto data = test::RealData();
  if (!data) GTEST_SKIP() << "CLUSTERVO_DATA does not name a folder with KITTI data";
  const auto labels = *data / "kitti_tracking/training/label_02/0003.txt";
  const Sequence sequence =
      OpenSequence({.folder = *data / "kitti_raw/2011_09_26/2011_09_26_drive_0013_sync",
                    .begin_frame = 42,
                    .end_frame = 48,
                    .detections_file = labels,
                    .detections_camera = 2});
  const BoxCamera camera = {sequence.camera, sequence.detections_offset_m};
  TaskPool pool(2);
  const Options options;
  const std::vector<ImageHashes> none;
  FrameSource frames({sequence, options, none}, pool);
  int moved = 0;
  for (const std::vector<ObjectBox>& boxes : DetectionsByFrame(sequence)) {
    const PreparedFrame prepared = frames.Next();
    for (const ObjectBox& drawn : boxes) {
      if (drawn.type != "Car" || drawn.occlusion > 0) continue;
      DetectionCounts counts;
      const auto given =
          DetectionsOfFrame({drawn}, camera, prepared.features, RigidClasses(), counts);
      ASSERT_EQ(given.size(), 1U);
      const double face_m = drawn.box3d->bottom_in_camera.z() - 0.5 * drawn.box3d->length_m;
      const double shift_px = -camera.left.fx * camera.offset_m / face_m;
      EXPECT_NEAR(given[0].box.right_px, drawn.right_px + shift_px, 0.6) << drawn.frame;
      EXPECT_GT(std::abs(shift_px), 1.0);
      ++moved;
    }
  }
  EXPECT_GE(moved, 6);
}

RigidTransform At(double x) {
  return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0.0, 0.0)};
}

// The truth of two frames with body 4, which is that of track 3 and of pixels with u above 50.
BodyTruthReader FakeTruth() {
  ObjectTruth objects;
  objects.timestamps_ns = {0, 1};
  objects.world_from_camera = {At(1.0), At(3.0)};
  TruthBody body;
  body.id = 4;
  body.track = 3;
  body.frames.resize(2, BodyFrame());
  objects.bodies = {body};
  return {objects, [](const ObjectTruth&, std::size_t, const Eigen::Vector2d& left_px,
                      const Eigen::Vector3d&) { return SeenBody{left_px.x() > 50 ? 4 : 0}; }};
}

Sequence TwoFrames() {
  Sequence sequence;
  sequence.first_frame = 7;
  sequence.images.resize(2);
  sequence.camera = {100, 100, 50, 40, 0.5, 100, 80};
  sequence.groundtruth_world_from_camera = {At(1.0), At(3.0)};
  ObjectBox label;
  label.frame = 8;
  label.track = 3;
  label.type = "Car";
  label.left_px = 10;
  label.top_px = 10;
  label.right_px = 30;
  label.bottom_px = 30;
  sequence.labels = {label};
  label.track = -1;
  sequence.labels.push_back(label);
  return sequence;
}

StereoFrame FrameWithABox() {
  StereoFrame frame;
  frame.detections = {{{11, 10, 31, 30}, "Car", 1.0}};
  frame.features.resize(2);
  frame.features[0].z_px = {20, 20, 10};
  frame.features[1].z_px = {60, 20, 50};
  return frame;
}

std::string Problem(const Sequence& sequence, const OracleSwitches& switches) {
  try {
    const Oracle oracle(sequence, switches, nullptr);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Oracle, ParsesTheNamesOfItsSwitches) {
  EXPECT_THAT(ParseOracle("camera,boxes").Names(), ElementsAre("boxes", "camera"));
  EXPECT_THAT(ParseOracle("none").Names(), IsEmpty());
  for (const char* bad : {"", "boxes,", "box", "none,boxes", "boxes, camera"}) {
    EXPECT_THROW(ParseOracle(bad), Error) << bad;
  }
}

TEST(Oracle, GivesOnlyWhatIsRequested) {
  BodyTruthReader truth = FakeTruth();
  const Sequence sequence = TwoFrames();
  StereoFrame frame = FrameWithABox();
  const auto feature_truth = TruthOfFeatures(1, frame.features, sequence.camera, truth);
  Oracle(sequence, {}, &truth).Give(1, feature_truth, frame);
  EXPECT_FALSE(frame.given.world_from_camera.has_value());
  EXPECT_THAT(frame.given.feature_body, IsEmpty());
  EXPECT_THAT(frame.given.detection_body, IsEmpty());

  Oracle(sequence, {.boxes = true}, &truth).Give(1, {}, frame);
  EXPECT_THAT(frame.given.detection_body, ElementsAre(BodyId{4}));
  EXPECT_THAT(frame.given.feature_body, IsEmpty());

  Oracle(sequence, {.labels = true}, &truth).Give(1, feature_truth, frame);
  EXPECT_THAT(frame.given.feature_body, ElementsAre(kStaticBody, BodyId{4}));
  EXPECT_FALSE(frame.given.world_from_camera.has_value());

  Oracle(sequence, {.camera = true}, nullptr).Give(1, {}, frame);
  EXPECT_EQ(frame.given.world_from_camera->translation().x(), 2.0);
}

TEST(Oracle, ABoxInAFrameWithoutTruthHasNoBody) {
  BodyTruthReader truth = FakeTruth();
  StereoFrame frame = FrameWithABox();
  Oracle(TwoFrames(), {.boxes = true}, &truth).Give(0, {}, frame);
  EXPECT_THAT(frame.given.detection_body, ElementsAre(BodyId()));
}

TEST(Oracle, IsRefusedWithoutTruth) {
  Sequence sequence = TwoFrames();
  EXPECT_THAT(Problem(sequence, {.boxes = true}), HasSubstr("--oracle: found \"boxes\""));
  EXPECT_THAT(Problem(sequence, {.labels = true}), HasSubstr("--oracle: found \"labels\""));
  EXPECT_EQ(Problem(sequence, {.camera = true}), "");
  sequence.groundtruth_world_from_camera.front().reset();
  EXPECT_THAT(Problem(sequence, {.camera = true}), HasSubstr("--oracle: found \"camera\""));
}

TEST(BodiesOfDetections, AreOneToOneWithAtLeastHalfOverlap) {
  const std::vector<Detection> detections = {
      {{0, 0, 10, 10}, "Car", 1.0}, {{1, 0, 11, 10}, "Car", 1.0}, {{40, 0, 50, 10}, "Car", 1.0}};
  // The first two detections overlap body 7 only, and the second one more. The third has an IoU of
  // 1/3 with body 9.
  EXPECT_THAT(BodiesOfDetections(detections, {{7, {2, 0, 12, 10}}, {9, {45, 0, 55, 10}}}),
              ElementsAre(BodyId(), BodyId{7}, BodyId()));
  EXPECT_THAT(BodiesOfDetections(detections, {}), ElementsAre(BodyId(), BodyId(), BodyId()));
  EXPECT_THAT(BodiesOfDetections({}, {{7, {2, 0, 12, 10}}}), IsEmpty());
}

}  // namespace
}  // namespace cvo::detections_test
