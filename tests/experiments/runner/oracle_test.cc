// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/oracle.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"

namespace cvo::oracle_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RigidTransform At(double x) {
  return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0.0, 0.0)};
}

// A truth with body 4, which is that of track 3 and of pixels with u above 50.
class FakeTruth : public BodyTruthReader {
 public:
  const ObjectTruth& objects() const override { return truth_; }
  int BodyOfTrack(int track) const override { return track == 3 ? 4 : -1; }
  LandmarkTruth Find(int, const Eigen::Vector2d& left_px, const Eigen::Vector3d&) override {
    return {static_cast<std::int16_t>(left_px.x() > 50 ? 4 : 0), PointMotion::kStill};
  }

 private:
  ObjectTruth truth_;
};

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
  EXPECT_FALSE(ParseOracle("none").any());
  for (const char* bad : {"", "boxes,", "box", "none,boxes", "boxes, camera"}) {
    EXPECT_THROW(ParseOracle(bad), Error) << bad;
  }
}

TEST(Oracle, GivesOnlyWhatIsRequested) {
  FakeTruth truth;
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
  FakeTruth truth;
  StereoFrame frame = FrameWithABox();
  Oracle(TwoFrames(), {.boxes = true}, &truth).Give(0, {}, frame);
  EXPECT_THAT(frame.given.detection_body, ElementsAre(BodyId()));
}

TEST(Oracle, AFeatureWithoutDepthIsUnknown) {
  FakeTruth truth;
  StereoFrame frame = FrameWithABox();
  frame.features[0].z_px[2] = frame.features[0].z_px[0];
  EXPECT_EQ(TruthOfFeatures(0, frame.features, TwoFrames().camera, truth)[0].body, -1);
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
}  // namespace cvo::oracle_test
