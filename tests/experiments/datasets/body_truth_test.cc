// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include "experiments/datasets/body_truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "experiments/datasets/formats/scene_truth.h"
#include "tests/experiments/datasets/folders.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int kFrames = 4;

// A row of objects.csv: a body of 0.5 m at (x, 0, 4), rotated by 90 degrees about y.
std::string ObjectRow(int frame, int id, const std::string& category, double x_m, int visible_px,
                      int alone_px) {
  return StrCat(frame, ",", id, ",thing_", id, ",", category, ",", x_m, ",0,4,0,",
                std::numbers::sqrt2 / 2, ",0,", std::numbers::sqrt2 / 2,
                ",0,0,0,0,0,0,0.5,0.5,0.5,", visible_px, ",", alone_px, ",",
                static_cast<double>(visible_px) / alone_px, ",0,1,1,5,5,1,1,5,5\n");
}

// Body 1 moves by 0.3 m per frame and body 2 stands still. The camera moves by 0.1 m per frame
// along x.
class SceneBodies : public testing::Test {
 protected:
  explicit SceneBodies(const std::string& category = "Ball") {
    std::string times, poses, objects = StrCat(kObjectsHeader, "\n");
    for (int k = 0; k < kFrames; ++k) {
      times += StrCat(k, ".000000e-01\n");
      poses += StrCat("1 0 0 ", 0.1 * k, " 0 1 0 0 0 0 1 0\n");
      objects += ObjectRow(k, 1, category, 0.3 * k, k == 1 ? 399 : 400, 400);
      objects += ObjectRow(k, 2, category, 1.0, 400, k == 2 ? 1400 : 1333);
      cv::Mat mask = cv::Mat::zeros(kTestHeight_px, kTestWidth_px, CV_16UC1);
      mask(cv::Rect(0, 0, 6, 8)) = cv::Scalar(k + 1);  // a different body in each frame
      folder_.Write("scene/instance_0/" + Digits(k, 6) + ".png", EncodePng(mask));
    }
    folder_.Write("scene/objects.csv", objects);
    folder_.Write("scene/times.txt", times);
    folder_.Write("scene/poses.txt", poses);
    folder_.Write("scene/calib.txt",
                  StrCat("P0: ", ProjectionRow(0.0), "\nP1: ", ProjectionRow(-0.5), "\n"));
    WriteImages(folder_, "scene/image_0", kFrames, 6);
    WriteImages(folder_, "scene/image_1", kFrames, 6);
  }
  Sequence Open(int begin = 0, int end = -1) const {
    return OpenSequence(
        {.folder = folder_.path() / "scene", .begin_frame = begin, .end_frame = end});
  }

  test::TempFolder folder_;
};

TEST_F(SceneBodies, HaveTheirPosesVisibilityAndTravel) {
  const auto reader = ReadBodyTruth(Open());
  ASSERT_NE(reader, nullptr);
  const ObjectTruth& truth = reader->objects();
  EXPECT_EQ(truth.frame_count(), 4u);
  EXPECT_EQ(truth.mover_travel_m, 0.2);
  EXPECT_FALSE(truth.movers_alone_move);
  EXPECT_NEAR(truth.world_from_camera[3]->translation().x(), 0.3, 1e-12);
  ASSERT_EQ(truth.bodies.size(), 2u);
  const TruthBody& first = truth.bodies[0];
  EXPECT_EQ(first.id, 1);
  EXPECT_EQ(first.name, "thing_1");
  EXPECT_EQ(first.category, "Ball");
  EXPECT_NEAR(first.travel_m, 0.9, 1e-12);
  EXPECT_TRUE(first.mover);
  EXPECT_NEAR(first.frames[2]->world_from_object.translation().x(), 0.6, 1e-12);
  EXPECT_TRUE(first.frames[0]->visible);
  EXPECT_FALSE(first.frames[1]->visible);  // 399 px
  const TruthBody& second = truth.bodies[1];
  EXPECT_FALSE(second.mover);
  EXPECT_TRUE(second.frames[1]->visible);   // 400 of 1333 px
  EXPECT_FALSE(second.frames[2]->visible);  // 400 of 1400 px
  EXPECT_EQ(reader->BodyOfTrack(2), 2);
  EXPECT_EQ(reader->BodyOfTrack(3), -1);
  EXPECT_EQ(reader->BodyOfTrack(-1), -1);
}

TEST_F(SceneBodies, AreCutToTheFrameRange) {
  const auto reader = ReadBodyTruth(Open(1, 3));
  const ObjectTruth& truth = reader->objects();
  EXPECT_EQ(truth.first_frame, 1);
  ASSERT_EQ(truth.frame_count(), 2u);
  EXPECT_NEAR(truth.bodies[0].frames[0]->world_from_object.translation().x(), 0.3, 1e-12);
  EXPECT_NEAR(truth.world_from_camera[0]->translation().x(), 0.1, 1e-12);
  EXPECT_NEAR(truth.bodies[0].travel_m, 0.3, 1e-12);
  // Frame 0 of the sequence has the mask of frame 1 in the folder.
  EXPECT_EQ(reader->Find(0, {2, 4}, {0, 0, 4}).body, 2);
}

TEST_F(SceneBodies, LandmarksAreLookedUpInTheMaskAwayFromEdges) {
  const auto reader = ReadBodyTruth(Open());
  const Eigen::Vector3d p(0, 0, 4);
  EXPECT_EQ(reader->Find(0, {2, 4}, p).body, 1);
  EXPECT_EQ(reader->Find(0, {3.4, 4}, p).body, 1);
  EXPECT_EQ(reader->Find(0, {3.6, 4}, p).body, -1);  // 2 px from the background
  EXPECT_EQ(reader->Find(0, {7.4, 4}, p).body, -1);
  EXPECT_EQ(reader->Find(0, {7.6, 4}, p).body, 0);
  EXPECT_EQ(reader->Find(0, {11.4, 7.4}, p).body, 0);
  EXPECT_EQ(reader->Find(0, {11.6, 4}, p).body, -1);  // outside
  EXPECT_EQ(reader->Find(0, {-0.6, 4}, p).body, -1);
  EXPECT_EQ(reader->Find(0, {std::nan(""), 4}, p).body, -1);
  EXPECT_EQ(reader->Find(1, {2, 4}, p).body, 2);
  EXPECT_EQ(reader->Find(2, {2, 4}, p).body, -1);  // no body 3
  EXPECT_EQ(reader->Find(0, {2, 4}, p).body, 1);
}

TEST_F(SceneBodies, LandmarksMoveWithTheirBody) {
  const auto reader = ReadBodyTruth(Open());
  EXPECT_EQ(reader->Find(0, {2, 4}, {0, 0, 4}).motion, PointMotion::kStill);
  EXPECT_EQ(reader->Find(1, {2, 4}, {0.9, 0, 4}).motion, PointMotion::kStill);
  cv::Mat mask(kTestHeight_px, kTestWidth_px, CV_16UC1, cv::Scalar(1));
  folder_.Write("scene/instance_0/000003.png", EncodePng(mask));
  EXPECT_EQ(reader->Find(3, {2, 4}, {0.6, 0, 4}).motion, PointMotion::kMoving);
}

TEST_F(SceneBodies, RefuseMissingFramesAndMasks) {
  const auto reader = ReadBodyTruth(Open());
  EXPECT_THAT(ErrorMessage([&] { reader->Find(4, {2, 4}, {0, 0, 4}); }), HasSubstr("frame 4"));
  EXPECT_THAT(ErrorMessage([&] { reader->Find(-1, {2, 4}, {0, 0, 4}); }), HasSubstr("frame -1"));
  fs::remove(folder_.path() / "scene/instance_0/000002.png");
  EXPECT_THAT(ErrorMessage([&] { reader->Find(2, {2, 4}, {0, 0, 4}); }), HasSubstr("000002.png"));
}

class StreetBodies : public SceneBodies {
 protected:
  StreetBodies() : SceneBodies("Car") {}
};

TEST_F(StreetBodies, MustTravelTwoMetresToBeMovers) {
  const auto reader = ReadBodyTruth(Open());
  EXPECT_EQ(reader->objects().mover_travel_m, 2.0);
  EXPECT_FALSE(reader->objects().bodies[0].mover);
}

// fx = fy = 1000 and a baseline of 0.5 m give a disparity of 125 px at 4 m. In camera 2, points are
// 0.06 m further to the right than in camera 0.
class LabelledBodies : public testing::Test {
 protected:
  LabelledBodies() : sequence_folder_(WriteTrackingSequence(folder_, kFrames)) {
    std::string calibration;
    for (const char* row :
         {"P0: 1000 0 6 0", "P1: 1000 0 6 -500", "P2: 1000 0 6 60", "P3: 1000 0 6 -440"}) {
      calibration += StrCat(row, " 0 1000 4 0 0 0 1 0\n");
    }
    calibration += StrCat("R0_rect: ", kIdentityRows, "\nTr_velo_to_cam: 0 -1 0 0 0 0 -1 0 1 0 0 0",
                          "\nTr_imu_to_velo: 1 0 0 0 0 1 0 0 0 0 1 0\n");
    folder_.Write("training/calib/0005.txt", calibration);
  }

  // A car 4 m ahead, facing along x: 4 m long, 2 m high and 2 m wide.
  static std::string Row(int frame, int track, double x_m, int occlusion = 0, double height_px = 30,
                         double heading_rad = 0.0) {
    return StrCat(frame, " ", track, " Car 0 ", occlusion, " -1.5 1 1 9 ", 1 + height_px, " 2 2 4 ",
                  x_m, " 1 4 ", heading_rad, "\n");
  }
  std::unique_ptr<BodyTruthReader> Read(const std::string& labels, int begin = 0, int end = -1) {
    folder_.Write("training/label_02/0005.txt", labels);
    return ReadBodyTruth(
        OpenSequence({.folder = sequence_folder_, .begin_frame = begin, .end_frame = end}));
  }

  test::TempFolder folder_;
  fs::path sequence_folder_;
};

TEST_F(LabelledBodies, AreInTheWorldFrameOfTheCamera) {
  // The camera moves forward by 1 m per frame, and the car stays 4 m ahead of it.
  std::string labels;
  for (int k = 0; k < kFrames; ++k) labels += Row(k, 0, 1.0);
  const auto reader = Read(labels + Row(1, 7, -2.0, 0, 30, 0.5));
  ASSERT_NE(reader, nullptr);
  const ObjectTruth& truth = reader->objects();
  EXPECT_EQ(truth.mover_travel_m, 2.0);
  EXPECT_TRUE(truth.movers_alone_move);
  ASSERT_EQ(truth.bodies.size(), 2u);
  const TruthBody& car = truth.bodies[0];
  EXPECT_EQ(car.id, 1);
  EXPECT_EQ(car.name, "track 0");
  EXPECT_EQ(car.category, "Car");
  EXPECT_NEAR(car.travel_m, 3.0, 1e-3);
  EXPECT_TRUE(car.mover);
  // The centre of the box: 1 m above its bottom, and converted from camera 2 to camera 0.
  const RigidTransform& first = car.frames[0]->world_from_object;
  EXPECT_NEAR((first.translation() - Eigen::Vector3d(1.06, 0.0, 4.0)).norm(), 0.0, 1e-9);
  const RigidTransform& last = car.frames[3]->world_from_object;
  EXPECT_NEAR((last.translation() - first.translation()).norm(), 3.0, 1e-3);
  const TruthBody& other = truth.bodies[1];
  EXPECT_EQ(other.id, 8);
  EXPECT_FALSE(other.frames[0].has_value());
  const Eigen::Vector3d forward =
      truth.world_from_camera[1]->rotation().conjugate() *
      (other.frames[1]->world_from_object.rotation() * Eigen::Vector3d::UnitX());
  EXPECT_NEAR((forward - Eigen::Vector3d(std::cos(0.5), 0, -std::sin(0.5))).norm(), 0.0, 1e-9);
  EXPECT_EQ(reader->BodyOfTrack(7), 8);
  EXPECT_EQ(reader->BodyOfTrack(1), -1);
}

TEST_F(LabelledBodies, AreVisibleUnlessHiddenOrSmall) {
  const auto reader =
      Read(Row(0, 0, 1, 1) + Row(1, 0, 1, 2) + Row(2, 0, 1, 0, 24.9) + Row(3, 0, 1, 0, 25));
  const auto& frames = reader->objects().bodies[0].frames;
  EXPECT_TRUE(frames[0]->visible);
  EXPECT_FALSE(frames[1]->visible);
  EXPECT_FALSE(frames[2]->visible);
  EXPECT_TRUE(frames[3]->visible);
}

TEST_F(LabelledBodies, AreCutToTheFrameRange) {
  const auto reader = Read(Row(0, 0, 1) + Row(2, 4, 1) + Row(3, 4, 1), 1, 3);
  const ObjectTruth& truth = reader->objects();
  EXPECT_EQ(truth.first_frame, 1);
  ASSERT_EQ(truth.bodies.size(), 1u);
  EXPECT_EQ(truth.bodies[0].id, 5);
  ASSERT_EQ(truth.bodies[0].frames.size(), 2u);
  EXPECT_FALSE(truth.bodies[0].frames[0].has_value());
  EXPECT_TRUE(truth.bodies[0].frames[1].has_value());
  EXPECT_EQ(reader->Find(1, {6, 4}, {1.06, 0, 4}).body, 5);
  EXPECT_EQ(reader->Find(0, {6, 4}, {1.06, 0, 4}).body, 0);
}

TEST_F(LabelledBodies, LandmarksAreLookedUpInTheBoxes) {
  // Body 1: x from -0.94 to 3.06, y from -1 to 1, z from 3 to 5.
  const auto reader = Read(Row(0, 0, 1.0) +
                           "0 -1 DontCare -1 -1 -10 20 1 30 9 -1 -1 -1 -1000 "
                           "-1000 -1000 -10\n");
  const auto body = [&](double x, double y, double z, double u_px = 6.0) {
    return static_cast<int>(reader->Find(0, {u_px, 4}, {x, y, z}).body);
  };
  EXPECT_EQ(body(1, 0, 4), 1);
  EXPECT_EQ(body(3.1, 0, 4.9), 1);     // within the tolerance at the side
  EXPECT_EQ(body(3.4, 0, 4), -1);      // beside the box
  EXPECT_EQ(body(4.0, 0, 4), 0);       // clearly beside it
  EXPECT_EQ(body(0, -1.7, 4), 0);      // above it
  EXPECT_EQ(body(1, 0.95, 4), -1);     // the road under it
  EXPECT_EQ(body(6, 1.2, 4), 0);       // the road beside it
  EXPECT_EQ(body(4.0, 0, 4, 15), -1);  // 5 px from a DontCare region
  EXPECT_EQ(body(4.0, 0, 4, 14), 0);
  EXPECT_EQ(body(1, 0, -4), -1);  // behind the camera
  EXPECT_EQ(body(1, 0, std::nan("")), -1);
  EXPECT_THAT(ErrorMessage([&] { reader->Find(4, {6, 4}, {1, 0, 4}); }), HasSubstr("frame 4"));
}

TEST_F(LabelledBodies, ToleratesLandmarkErrorsAlongTheRay) {
  // The box extends from 39 to 41 m, where half a pixel of disparity is 1.6 m of depth.
  const auto reader = Read("0 0 Car 0 0 -1.5 1 1 9 31 2 2 4 0 1 40 0\n");
  const auto body = [&](double x, double z) {
    return static_cast<int>(reader->Find(0, {6, 4}, {x, 0, z}).body);
  };
  EXPECT_EQ(body(0, 42), 1);
  EXPECT_EQ(body(0, 38), 1);
  EXPECT_EQ(body(0, 43.5), -1);
  EXPECT_EQ(body(0, 36), -1);
  EXPECT_EQ(body(0, 50), 0);
  EXPECT_EQ(body(0, 30), 0);
  EXPECT_EQ(body(3, 42), 0);  // beside it
}

TEST_F(LabelledBodies, ALandmarkOnTwoBodiesIsNotJudged) {
  const auto reader = Read(Row(0, 0, 1.0) + Row(0, 1, 3.0));
  EXPECT_EQ(reader->Find(0, {6, 4}, {2.0, 0, 4}).body, -1);
  EXPECT_EQ(reader->Find(0, {6, 4}, {0.0, 0, 4}).body, 1);
  EXPECT_EQ(reader->Find(0, {6, 4}, {4.5, 0, 4}).body, 2);
}

TEST_F(LabelledBodies, StandingBodiesNeverMoveDespiteLabelJitter) {
  const auto motion = [&](double step_m) {
    std::string labels;
    // Cancels the motion of the camera, which is along z.
    for (int k = 0; k < 3; ++k) {
      labels += StrCat(k, " 0 Car 0 0 -1.5 1 1 9 31 2 2 4 1 1 ", 8.0 - k + step_m * k, " 0\n");
    }
    return Read(labels)->Find(2, {6, 4}, {1, 0, 6.0 + 2 * step_m}).motion;
  };
  EXPECT_EQ(motion(0.1), PointMotion::kStill);
  EXPECT_EQ(motion(1.5), PointMotion::kMoving);
}

TEST_F(LabelledBodies, NeedBoxesAndCameraPoses) {
  EXPECT_EQ(Read("0 -1 DontCare -1 -1 -10 1 1 2 2 -1000 -1000 -1000 -10 -1 -1 -1\n"), nullptr);
  EXPECT_EQ(Read(Row(0, 0, 1), 1), nullptr);
  EXPECT_NE(Read(Row(1, 0, 1), 1), nullptr);
  fs::remove(folder_.path() / "training/oxts/0005.txt");
  EXPECT_EQ(Read(Row(0, 0, 1)), nullptr);
}

TEST_F(LabelledBodies, RefuseTwoBoxesOfATrackInAFrame) {
  EXPECT_THAT(ErrorMessage([&] { Read(Row(1, 3, 1) + Row(1, 3, 2)); }),
              HasSubstr("found track 3 of frame 1 a second time"));
}

}  // namespace

}  // namespace cvo

namespace cvo::scene_calibration_test {
namespace {

struct Scene {
  test::TempFolder root;
  Sequence sequence;

  explicit Scene(const std::string& rig_error) {
    root.Write("objects.csv", "");
    root.Write("manifest.json", "{" + rig_error + "}");
    sequence.folder = root.path();
    sequence.camera = {720.0, 720.0, 599.5, 179.5, 0.5, 1200, 360};
  }
  Vector6d Field() const { return TrueRightField(sequence).value(); }
  static std::string Error(const std::string& shift_px, const std::string& rotation_deg,
                           const std::string& focal) {
    return R"("rig_error": {"shift_px": )" + shift_px + R"(, "rotation_deg": )" + rotation_deg +
           R"(, "focal": )" + focal + "}";
  }
};

TEST(TrueRightField, IsZeroForAnExactCalibration) { EXPECT_LT(Scene("").Field().norm(), 1e-12); }

TEST(TrueRightField, ShiftOfThePrincipalPointIsTheMean) {
  const Vector6d field_px = Scene(Scene::Error("0.2", "[0, 0, 0]", "0")).Field();
  EXPECT_LT((field_px - 0.2 * Vector6d::Unit(0)).norm(), 1e-9);
}

TEST(TrueRightField, RollIsASlopeAlongTheColumnsAndFocalLengthOneAlongTheRows) {
  // The right camera is rolled about z (forward, y down) by a milliradian: its picture turns the
  // other way, so that points below the middle, at y = 180 px, move right by 0.18 px.
  const Vector6d rolled_px = Scene(Scene::Error("0", "[0, 0, 0.0572957795]", "0")).Field();
  EXPECT_NEAR(rolled_px[2], 0.18, 1e-3);
  EXPECT_NEAR(rolled_px[1], 0.0, 1e-3);
  const Vector6d longer_px = Scene(Scene::Error("0", "[0, 0, 0]", "0.001")).Field();
  EXPECT_NEAR(longer_px[1], 0.6, 1e-9);
}

TEST(TrueRightField, KnownShiftIsNotPartOfIt) {
  Scene scene(Scene::Error("0.2", "[0, 0, 0]", "0"));
  scene.sequence.camera.right_shift_px = 0.15;
  EXPECT_NEAR(scene.Field()[0], 0.05, 1e-9);
}

TEST(TrueRightField, IsUnknownForRecordingsAndPerturbedScenes) {
  Scene scene("");
  scene.sequence.perturbation.disparity_error_px = 0.1;
  EXPECT_FALSE(TrueRightField(scene.sequence).has_value());
  scene.sequence.perturbation = {};
  std::filesystem::remove(scene.root.path() / "objects.csv");
  EXPECT_FALSE(TrueRightField(scene.sequence).has_value());
}

TEST(TrueRightField, RefusesADamagedManifest) {
  const Scene scene(Scene::Error("true", "[0, 0, 0]", "0"));
  EXPECT_THAT(ErrorMessage([&] { return scene.Field(); }),
              ::testing::HasSubstr("manifest.json, rig_error, field shift_px"));
}

}  // namespace
}  // namespace cvo::scene_calibration_test
