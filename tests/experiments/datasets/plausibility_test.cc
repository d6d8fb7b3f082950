// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/datasets/sequence.h"
#include "tests/experiments/metrics/objects/object_world.h"

namespace cvo {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

// Returns the findings on a body with these x coordinates, in m, at 10 Hz from frame 100 on.
std::vector<std::string> Said(const std::vector<double>& places_m) {
  std::vector<RigidTransform> poses;
  for (const double x : places_m) poses.push_back(test::At(x));
  ObjectTruth truth = test::TruthOf(static_cast<int>(poses.size()));
  truth.first_frame = 100;
  test::AddBody(truth, poses);
  Sequence sequence;
  sequence.first_frame = truth.first_frame;
  sequence.timestamps_ns = truth.timestamps_ns;
  sequence.groundtruth_world_from_camera = truth.world_from_camera;
  EXPECT_THAT(FindImplausible(sequence, nullptr), IsEmpty());
  return FindImplausible(sequence, &truth);
}

TEST(Plausibility, ReportsAJumpingBodyWithItsFrame) {
  // Modelled on the label of the first car of KITTI tracking 0003, between frames 60 and 61.
  EXPECT_THAT(
      Said({0.0, 0.4, 0.77, -0.37, 0.05, 0.45}),
      ElementsAre(AllOf(
          StartsWith("ground truth of body body_1, frame 103: its velocity differs by 15.1 m/s"),
          Not(HasSubstr("more")))));
  EXPECT_THAT(Said({0.0, 3.0, 3.0, 3.0}),
              ElementsAre(HasSubstr("frame 101: its velocity differs by 30 m/s")));
  EXPECT_THAT(Said({8.0, 8.0, 4.0, 4.0}),
              ElementsAre(AllOf(HasSubstr("frame 102: its velocity differs by 40 m/s"),
                                Not(HasSubstr("more")))));
  EXPECT_THAT(Said({0.0, 0.0, 0.0, 3.0}),
              ElementsAre(HasSubstr("frame 103: its velocity differs by 30 m/s")));
  EXPECT_THAT(Said({0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0}),
              ElementsAre(AllOf(HasSubstr("frame 103: "), HasSubstr(", and 1 more like it"))));
}

TEST(Plausibility, AcceptsJitterBouncesAndBraking) {
  EXPECT_THAT(Said({0.1, 1.4, 3.1, 4.4, 6.1, 7.4}), IsEmpty());   // label errors of 0.1 m
  EXPECT_THAT(Said({0.0, 2.0, 4.0, 2.0, 0.0, -2.0}), IsEmpty());  // a bounce off a wall at 20 m/s
  EXPECT_THAT(Said({0.0, 3.0, 6.0, 6.0, 6.0, 6.0}), IsEmpty());   // an instant stop
  EXPECT_THAT(Said({0.0, 3.0}), IsEmpty());                       // too few frames to compare
}

TEST(Plausibility, DoesNotCompareAcrossFramesWithoutTruth) {
  ObjectTruth truth = test::TruthOf(6);
  test::AddBody(truth, test::Line(6, 0.0));
  truth.bodies[0].frames[3]->world_from_object = test::At(50.0);
  truth.bodies[0].frames[2].reset();
  truth.bodies[0].frames[4].reset();
  Sequence sequence;
  sequence.timestamps_ns = truth.timestamps_ns;
  sequence.groundtruth_world_from_camera = truth.world_from_camera;
  EXPECT_THAT(FindImplausible(sequence, &truth), IsEmpty());
}

TEST(Plausibility, ReportsBaselinesInTheWrongUnit) {
  Sequence sequence;
  for (const double usual_m : {0.001, 0.54, 10.0}) {
    sequence.camera.baseline_m = usual_m;
    EXPECT_THAT(FindImplausible(sequence, nullptr), IsEmpty()) << usual_m;
  }
  for (const double odd_m : {0.0005, 120.0}) {
    sequence.camera.baseline_m = odd_m;
    EXPECT_THAT(FindImplausible(sequence, nullptr),
                ElementsAre(StartsWith("calibration: a baseline of ")));
  }
}

}  // namespace
}  // namespace cvo
