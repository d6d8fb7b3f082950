// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/datasets/body_truth.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

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

TEST(TrueRightField, YawToTheRightMovesPointsToTheLeft) {
  const Vector6d field_px = Scene(Scene::Error("0", "[0, 0.0572957795, 0]", "0")).Field();
  // -f yaw (1 + X^2), with X up to 0.833 at the edges.
  EXPECT_NEAR(field_px[3], -0.72 * 0.833 * 0.833, 2e-3);
  EXPECT_NEAR(field_px[0], -0.72 * (1.0 + 0.833 * 0.833 / 3.0), 2e-3);
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
