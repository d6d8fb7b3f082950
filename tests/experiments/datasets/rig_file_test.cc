// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/calibration/rig_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "experiments/datasets/calibration/stereo_rig.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::rig_file_test {
namespace {

namespace fs = std::filesystem;

// The calibration of the EuRoC cameras, as published in their sensor.yaml.
StereoRig Euroc() {
  Eigen::Matrix3d left_turn;
  left_turn << 0.0148655429818, -0.999880929698, 0.00414029679422,  //
      0.999557249008, 0.0149672133247, 0.025715529948,              //
      -0.0257744366974, 0.00375618835797, 0.999660727178;
  Eigen::Matrix3d right_turn;
  right_turn << 0.0125552670891, -0.999755099723, 0.0182237714554,  //
      0.999598781151, 0.0130119051815, 0.0251588363115,             //
      -0.0253898008918, 0.0179005838253, 0.999517347078;
  const Eigen::Vector3d left_at(-0.0216401454975, -0.064676986768, 0.00981073058949);
  const Eigen::Vector3d right_at(-0.0198435579556, 0.0453689425024, 0.00786212447038);
  const Eigen::Matrix3d rotation = right_turn.inverse() * left_turn;
  StereoRig rig;
  rig.left = {458.654,
              457.296,
              367.215,
              248.375,
              LensModel::kPlumbBob,
              {-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05}};
  rig.right = {457.587,
               456.134,
               379.999,
               255.238,
               LensModel::kPlumbBob,
               {-0.28368365, 0.07451284, -0.00010473, -3.555907e-05}};
  rig.right_from_left =
      RigidTransform(rotation, Eigen::Vector3d(right_turn.inverse() * (left_at - right_at)));
  return rig;
}

// Compares with the rectification that ships with ORB-SLAM2 for these cameras.
TEST(Rectification, MatchesOrbSlam2OnEuroc) {
  const Rectification rectification(Euroc(), {752, 480});
  const StereoCamera& camera = rectification.camera();
  EXPECT_NEAR(camera.fx, 435.2046959714599, 1e-3);
  EXPECT_NEAR(camera.fy, 435.2046959714599, 1e-3);
  EXPECT_NEAR(camera.cx, 367.4517211914062, 1e-3);
  EXPECT_NEAR(camera.cy, 252.2008514404297, 1e-3);
  EXPECT_NEAR(camera.fx * camera.baseline_m, 47.90639384423901, 1e-3);
  const Eigen::Vector3d left(0.999966347530033, -0.001422739138722922, 0.008079580483432283);
  const Eigen::Vector3d right(0.9999633526194376, -0.003625811871560086, 0.007755443660172947);
  EXPECT_LT((rectification.rectified_from_left().row(0).transpose() - left).norm(), 1e-9);
  EXPECT_LT((rectification.rectified_from_right().row(0).transpose() - right).norm(), 1e-9);
}

// Projects a point in the frame of the camera to its pixel, with subpixel precision.
Eigen::Vector2d Seen(const LensCamera& camera, const Eigen::Vector3d& p) {
  const double x = p.x() / p.z();
  const double y = p.y() / p.z();
  const double r2 = x * x + y * y;
  const std::vector<double>& k = camera.coefficients;
  double u = x;
  double v = y;
  if (camera.lens == LensModel::kPlumbBob) {
    const double radial = 1.0 + k[0] * r2 + k[1] * r2 * r2;
    u = x * radial + 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x);
    v = y * radial + k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y;
  } else if (camera.lens == LensModel::kEquidistant) {
    const double r = std::sqrt(r2);
    const double a = std::atan(r);
    const double turned =
        a * (1.0 + a * a * (k[0] + a * a * (k[1] + a * a * (k[2] + a * a * k[3]))));
    u = turned / r * x;
    v = turned / r * y;
  }
  return {camera.fx * u + camera.cx, camera.fy * v + camera.cy};
}

// The image of a point light lies, after rectification, where the rectified camera projects the
// point: on the same row in both images, with the disparity of its depth.
void ExpectRectified(const StereoRig& rig) {
  const cv::Size size(752, 480);
  const Rectification rectification(rig, size);
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0.3, -0.2, 3.0), Eigen::Vector3d(-0.8, 0.4, 4.0)}) {
    const auto spot = [&](const LensCamera& camera, const Eigen::Vector3d& p_in_camera) {
      const Eigen::Vector2d at = Seen(camera, p_in_camera);
      cv::Mat image(size, CV_8UC1);
      for (int v = 0; v < image.rows; ++v) {
        for (int u = 0; u < image.cols; ++u) {
          const double d2 = (at - Eigen::Vector2d(u, v)).squaredNorm();
          image.at<unsigned char>(v, u) =
              cv::saturate_cast<unsigned char>(250.0 * std::exp(-d2 / 18.0));
        }
      }
      return image;
    };
    const auto center = [](const cv::Mat& image) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int v = 0; v < image.rows; ++v) {
        for (int u = 0; u < image.cols; ++u) {
          sum += image.at<unsigned char>(v, u) * Eigen::Vector3d(u, v, 1.0);
        }
      }
      return Eigen::Vector2d(sum.head<2>() / sum.z());
    };
    const auto z_px = rectification.camera().Project(rectification.rectified_from_left() * p);
    ASSERT_TRUE(z_px);
    const Eigen::Vector2d left = center(rectification.Left(spot(rig.left, p)));
    const Eigen::Vector2d right =
        center(rectification.Right(spot(rig.right, rig.right_from_left * p)));
    EXPECT_NEAR(left.x(), z_px->x(), 0.1);
    EXPECT_NEAR(left.y(), z_px->y(), 0.1);
    EXPECT_NEAR(right.x(), z_px->z(), 0.1);
    EXPECT_NEAR(right.y(), left.y(), 0.1);
  }
}

TEST(Rectification, PointsLieWhereTheCameraProjectsThem) { ExpectRectified(Euroc()); }

TEST(Rectification, SupportsEquidistantLenses) {
  StereoRig rig = Euroc();
  rig.left.lens = rig.right.lens = LensModel::kEquidistant;
  rig.left.coefficients = {-0.01, 0.02, -0.01, 0.002};
  rig.right.coefficients = {-0.012, 0.018, -0.009, 0.002};
  ExpectRectified(rig);
}

class RigFile : public testing::Test {
 protected:
  StereoRig Read(const std::string& text) const {
    return ReadStereoRig(folder_.Write("calib", text));
  }
  void ExpectError(const std::string& text, const std::string& message) const {
    EXPECT_THAT(ErrorMessage([&] { Read(text); }), testing::HasSubstr(message));
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

// One rig as each program writes it: 450 px, a baseline of 0.12 m, no distortion.
TEST_F(RigFile, ReadsOneRigInEveryFormat) {
  const std::string k = "[450., 0., 319.5, 0., 450., 239.5, 0., 0., 1.]\n";
  const std::string turn = "[1., 0., 0., 0., 1., 0., 0., 0., 1.]\n";
  const auto kalibr = [](const char* name, const char* key, double x) {
    return StrCat(name, ":\n  camera_model: pinhole\n  intrinsics: [450., 450., 319.5, 239.5]\n",
                  "  distortion_model: radtan\n  distortion_coeffs: [0., 0., 0., 0.]\n",
                  "  resolution: [640, 480]\n  ", key, ": [[1., 0., 0., ", x,
                  "], [0., 1., 0., 0.01], [0., 0., 1., 0.], [0., 0., 0., 1.]]\n");
  };
  const auto matrices = [&](const char* zeros) {
    return StrCat("M1: ", k, "D1: [", zeros, "]\nM2: ", k, "D2: [", zeros, "]\n");
  };
  const auto ros = [&](double offset_px) {
    return StrCat(
        "image_width: 640\nimage_height: 480\ncamera_matrix:\n  rows: 3\n  data: ", k,
        "distortion_model: plumb_bob\ndistortion_coefficients:\n  data: [0, 0, 0, 0, 0]\n",
        "rectification_matrix:\n  data: ", turn, "projection_matrix:\n  data: [450, 0, ", "319.5, ",
        offset_px, ", 0, 450, 239.5, 0, 0, 0, 1, 0]\n");
  };
  const auto message = [&](double offset_px, const char* names) {  // as a program of ROS prints it
    const auto key = [&](int i) { return std::string(1, names[i]); };
    return StrCat("header:\n  stamp: 5\nheight: 480\nwidth: 640\ndistortion_model: plumb_bob\n",
                  key(0), ": [0, 0, 0, 0, 0]\n", key(1), ": ", k, key(2), ": ", turn, key(3),
                  ": [450, 0, 319.5, ", offset_px, ", 0, 450, 239.5, 0, 0, 0, 1, 0]\n---\n");
  };
  const auto orb = [](const std::string& name, const std::string& more) {
    return StrCat(name, ".fx: 450.0\n", name, ".fy: 450.0\n", name, ".cx: 319.5\n", name,
                  ".cy: 239.5\n", more);
  };
  const std::string pose = StrCat("R: ", turn, "T: [-0.12, 0., 0.]\n");
  struct Case {
    std::string first;
    std::string second = {};
  };
  for (const Case& c : {
           Case{kalibr("cam0", "T_cam_imu", 0.05) + kalibr("cam1", "T_cam_imu", -0.07)},
           Case{"%YAML:1.0\n" + kalibr("cam0", "T_imu_cam", -0.05) +
                kalibr("cam1", "T_imu_cam", 0.07)},
           Case{matrices("0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0") + pose},
           Case{matrices("0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0") + pose},
           Case{"%YAML:1.0\n---\n" + matrices("0, 0, 0, 0, 0"), "%YAML:1.0\n---\n" + pose},
           Case{ros(0.0), ros(-54.0)},
           Case{message(0.0, "DKRP"), message(-54.0, "DKRP")},
           Case{message(0.0, "dkrp"), message(-54.0, "dkrp")},
           Case{orb("Camera", "Camera.bf: 54.0\nCamera.k1: 0.0\n")},
           Case{orb("Camera1", orb("Camera2",
                                   "Stereo.T_c1_c2: !!opencv-matrix\n  rows: 4\n  data: [1, 0, 0, "
                                   "0.12, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n"))},
           Case{orb("Camera",
                    StrCat("LEFT.K: ", k, "LEFT.D: [0, 0, 0, 0, 0]\nLEFT.R: ", turn,
                           "LEFT.P: [450, 0, 319.5, 0, 0, 450, 239.5, 0, 0, 0, 1, 0]\n",
                           "RIGHT.K: ", k, "RIGHT.D: [0, 0, 0, 0, 0]\nRIGHT.R: ", turn,
                           "RIGHT.P: [450, 0, 319.5, -54, 0, 450, 239.5, 0, 0, 0, 1, 0]\n"))},
       }) {
    const fs::path second = c.second.empty() ? "" : folder_.Write("second", c.second);
    const StereoRig rig = ReadStereoRig(folder_.Write("calib", c.first), second);
    EXPECT_TRUE(IsRectified(rig)) << c.first;
    EXPECT_EQ(rig.left.fx, 450.0) << c.first;
    EXPECT_EQ(rig.right.cy, 239.5) << c.first;
    EXPECT_NEAR(rig.right_from_left.translation().x(), -0.12, 1e-12) << c.first;
  }
  ExpectError(ros(0.0), "found one camera alone, expected both cameras: --calib LEFT RIGHT");
  ExpectError(matrices("0, 0, 0, 0"), "of two files give both");
  ExpectError(pose, "found keys \"R T\", expected a calibration of ours");
  ExpectError("fx: 1\nfx: 2\n", "fx: found the key twice");
  ExpectError("fx: 1\n---\nfx: 2\n", "found 2 YAML documents");
  EXPECT_THAT(ErrorMessage([&] {
                ReadStereoRig(folder_.Write("a", ros(-54.0)), folder_.Write("b", ros(0.0)));
              }),
              testing::HasSubstr("left and right may be swapped"));
}

// Calibrations that are impossible for cameras with images of this size.
TEST_F(RigFile, RefusesImpossibleCameras) {
  const auto expect_error = [&](const std::string& text, const std::string& message) {
    EXPECT_THAT(ErrorMessage([&] { CheckCameras(Read(text), 640, 480, "calib"); }),
                testing::HasSubstr(message));
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
      "right_from_left: found a matrix whose R R^T is off the identity");
}

}  // namespace
}  // namespace cvo::rig_file_test
