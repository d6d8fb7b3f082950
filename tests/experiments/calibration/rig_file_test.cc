// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/calibration/rig_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "experiments/calibration/camera_check.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

class RigFile : public testing::Test {
 protected:
  StereoRig Read(const std::string& text) const {
    return ReadStereoRig(folder_.Write("calib", text));
  }
  void ExpectError(const std::string& text, const std::string& message) const {
    try {
      Read(text);
      ADD_FAILURE() << "no error: " << message;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(message));
    }
  }

  test::TempFolder folder_;
};

TEST_F(RigFile, ReadsOurRectifiedPair) {
  for (const char* text :
       {"fx: 700\nfy: 701\ncx: 320\ncy: 240\nbaseline_m: 0.12\nwidth_px: 640\nheight_px: 480\n",
        R"({"fx": 700, "fy": 701, "cx": 320, "cy": 240, "baseline_m": 0.12,
            "width_px": 640, "height_px": 480})"}) {
    const StereoRig rig = Read(text);
    EXPECT_TRUE(IsRectified(rig));
    EXPECT_EQ(rig.left.fy, 701.0);
    EXPECT_EQ(rig.right_from_left.translation().x(), -0.12);
    EXPECT_EQ(rig.height_px, 480);
  }
}

TEST_F(RigFile, ReadsOurLensModels) {
  const StereoRig rig = Read(
      "left: {fx: 1, fy: 2, cx: 3, cy: 4, lens: equidistant, coefficients: [1, 2, 3, 4]}\n"
      "right: {fx: 1, fy: 2, cx: 3, cy: 4, lens: equidistant, coefficients: [0, 0, 0, 0]}\n"
      "right_from_left: [1, 0, 0, -0.1, 0, 1, 0, 0, 0, 0, 1, 0]\n");
  EXPECT_FALSE(IsRectified(rig));
  EXPECT_EQ(rig.left.lens, LensModel::kEquidistant);
  EXPECT_EQ(rig.left.coefficients[3], 4.0);
}

TEST_F(RigFile, ReadsAKalibrCamchain) {
  const StereoRig rig = Read(
      "cam0:\n  cam_overlaps: [1]\n  camera_model: pinhole\n"
      "  distortion_coeffs: [-0.28, 0.07, 0.0002, 1.8e-05]\n  distortion_model: radtan\n"
      "  intrinsics: [458.6, 457.3, 367.2, 248.4]\n  resolution: [752, 480]\n"
      "  rostopic: /cam0/image_raw\n"
      "cam1:\n  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, -0.11]\n  - [0.0, 1.0, 0.0, 0.0004]\n"
      "  - [0.0, 0.0, 1.0, -0.0008]\n  - [0.0, 0.0, 0.0, 1.0]\n  camera_model: pinhole\n"
      "  distortion_coeffs: [-0.28, 0.07, 0.0002, 1.8e-05]\n  distortion_model: radtan\n"
      "  intrinsics: [457.6, 456.1, 380.0, 255.2]\n  resolution: [752, 480]\n");
  EXPECT_EQ(rig.left.lens, LensModel::kPlumbBob);
  EXPECT_EQ(rig.right.cx, 380.0);
  EXPECT_EQ(rig.right_from_left.translation().z(), -0.0008);
  EXPECT_EQ(rig.width_px, 752);
}

TEST_F(RigFile, ReadsOpenCvCalibration) {
  const std::string matrix = ": !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: ";
  const StereoRig rig = Read(
      "%YAML:1.0\n---\nM1" + matrix + "[ 500., 0., 320., 0., 501., 240., 0., 0., 1. ]\nD1" +
      matrix + "[ -0.2, 0.1, 0., 0., 0. ]\nM2" + matrix +
      "[ 502., 0., 321., 0., 503., 241., 0., 0., 1. ]\nD2" + matrix + "[ 0., 0., 0., 0., 0. ]\nR" +
      matrix + "[ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]\nT" + matrix + "[ -6.e-02, 1.e-04, 0. ]\n");
  EXPECT_EQ(rig.left.coefficients[0], -0.2);
  EXPECT_EQ(rig.right.lens, LensModel::kPinhole);  // because all coefficients are zero
  EXPECT_EQ(rig.right.fy, 503.0);
  EXPECT_EQ(rig.right_from_left.translation().x(), -0.06);
}

// Calibrations that are impossible for cameras with images of this size.
TEST_F(RigFile, RefusesImpossibleCameras) {
  const auto expect_error = [&](const std::string& text, const std::string& message) {
    try {
      CheckCameras(Read(text), 640, 480, "calib");
      ADD_FAILURE() << "no error: " << message;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(message));
    }
  };
  expect_error("fx: 700\nfy: 700\ncx: 640\ncy: 240\nbaseline_m: 0.1\n",
               "calib, left camera: found cx 640, cy 240, expected a centre within the images of "
               "640x480 px");
  expect_error("fx: 700\nfy: 300\ncx: 320\ncy: 240\nbaseline_m: 0.1\n",
               "found fx 700, fy 300, expected focal lengths within a factor of 2");
  expect_error(
      "left: {fx: 500, fy: 500, cx: 320, cy: 240}\n"
      "right: {fx: 500, fy: 500, cx: 320, cy: -1}\n"
      "right_from_left: [1, 0, 0, -0.1, 0, 1, 0, 0, 0, 0, 1, 0]\n",
      "right camera: found cx 320, cy -1");
  const std::string opencv =
      "K1: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nD1: [0, 0, 0, 0]\n"
      "K2: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nD2: [0, 0, 0, 0]\n"
      "R: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT: [-0.1, 0, 0]\n";
  CheckCameras(Read(opencv + "image_width: 640\nimage_height: 480\n"), 640, 480, "calib");
  expect_error(opencv + "image_width: 1280\nimage_height: 960\n", "a calibration of 1280x960 px");
}

TEST_F(RigFile, ReadsKittiText) {
  const StereoRig rig =
      Read("P0: 700 0 600 0 0 700 180 0 0 0 1 0\nP1: 700 0 600 -350 0 700 180 0 0 0 1 0\n");
  EXPECT_TRUE(IsRectified(rig));
  EXPECT_EQ(rig.right_from_left.translation().x(), -0.5);
}

// Regression: a list that contains itself, and nested lists that expand a few bytes to gigabytes,
// used to crash the program.
TEST_F(RigFile, RefusesEndlessLists) {
  const std::string cameras =
      "left: {fx: 1, fy: 2, cx: 3, cy: 4}\nright: {fx: 1, fy: 2, cx: 3, cy: 4}\nright_from_left: ";
  ExpectError(cameras + "&a [*a]\n", "found more than 1000 values");
  std::string lists = "&a0 [1, 2, 3]";
  for (int i = 0; i < 30; ++i) lists += StrCat(", &a", i + 1, " [*a", i, ", *a", i, "]");
  ExpectError(cameras + "[" + lists + "]\n", "found more than 1000 values");
}

TEST_F(RigFile, BadInput) {
  ExpectError("fx: 1\nfy: 1\ncx: 1\ncy: 1\nbaseline: 1\n",
              "key \"baseline\" (did you mean baseline_m?)");
  ExpectError("fx: 1\nfy: 1\ncx: 1\ncy: 1\n", "baseline_m: found nothing");
  ExpectError("fx: 1\nfy: 1\ncx: 1\ncy: 1\nbaseline_m: -0.1\n", "found -0.1, expected a positive");
  ExpectError("fx: -1\nfy: 1\ncx: 1\ncy: 1\nbaseline_m: 0.1\n",
              "left camera: found focal lengths -1, 1");
  ExpectError("fx: nan\nfy: 1\ncx: 1\ncy: 1\nbaseline_m: 0.1\n",
              "fx: found \"nan\", expected a number");
  ExpectError("fx: [1\n", "calib:");
  ExpectError("text", "no keys");
  ExpectError("left: {fx: 1, fy: 2, cx: 3, cy: 4, lens: fish}\nright: {}\n", "found \"fish\"");
  ExpectError(
      "left: {fx: 1, fy: 2, cx: 3, cy: 4}\nright: {fx: 1, fy: 2, cx: 3, cy: 4}\n"
      "right_from_left: [1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0]\n",
      "left and right may be swapped");
  ExpectError(
      "left: {fx: 1, fy: 2, cx: 3, cy: 4}\nright: {fx: 1, fy: 2, cx: 3, cy: 4}\n"
      "right_from_left: [2, 0, 0, -0.1, 0, 1, 0, 0, 0, 0, 1, 0]\n",
      "no rotation");
}

}  // namespace
}  // namespace cvo
