// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests that each check passes on a correct scene and fails when its fault is injected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/scene_check/check_scene.h"
#include "experiments/metrics/trajectory.h"
#include "tests/experiments/datasets/scene_check/rays.h"
#include "tests/support/error_message.h"
#include "tests/support/image_file.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> Failed(const std::vector<SceneCheck>& checks) {
  std::vector<std::string> names;
  for (const SceneCheck& check : checks) {
    if (!check.Passed()) names.push_back(check.name);
  }
  return names;
}

std::string Describe(const SceneCheckReport& report) {
  std::string text;
  for (const SceneCheck& check : report.checks) {
    text += StrCat(check.name, " ", check.figure, " ", check.where, "\n");
  }
  return text;
}

class SceneCheckTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    original_ = new test::TempFolder();
    test::WriteRayScene(original_->path() / "rays");
  }
  static void TearDownTestSuite() {
    delete original_;
    original_ = nullptr;
  }
  SceneCheckTest() { fs::copy(original_->path() / "rays", rays(), fs::copy_options::recursive); }

  fs::path rays() const { return folder_.path() / "rays"; }

  // The failed checks except those of the manifest, which every change of a file breaks.
  std::vector<std::string> FailedNow() const {
    std::vector<std::string> failed = Failed(CheckScene(rays(), 2).checks);
    std::erase_if(failed, [](const std::string& name) { return name.starts_with("manifest_"); });
    return failed;
  }
  // Changes an image in place.
  void Edit(const std::string& name, const std::function<void(cv::Mat&)>& change) const {
    cv::Mat image = ReadImageFile(rays() / name, cv::IMREAD_UNCHANGED);
    ASSERT_FALSE(image.empty()) << name;
    change(image);
    test::WriteImageFile(rays() / name, image);
  }
  void EditAll(const std::string& folder, const std::string& extension,
               const std::function<void(cv::Mat&)>& change) const {
    for (int i = 0; i < test::RayScene::kFrames; ++i) {
      Edit(folder + "/00000" + std::to_string(i) + extension, change);
    }
  }
  void Replace(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = ReadFileBytes(rays() / name);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << name << ": " << from;
    WriteFileBytes(rays() / name, text.replace(at, from.size(), to));
  }

  static test::TempFolder* original_;
  test::TempFolder folder_;
};

test::TempFolder* SceneCheckTest::original_ = nullptr;

void Shift(cv::Mat& image, double du, double dv) {
  const cv::Matx23d move(1.0, 0.0, du, 0.0, 1.0, dv);
  cv::warpAffine(image.clone(), image, move, image.size(), cv::INTER_CUBIC, cv::BORDER_REPLICATE);
}

TEST_F(SceneCheckTest, AScenePassesOnAnyNumberOfThreads) {
  const SceneCheckReport one = CheckScene(rays(), 1);
  EXPECT_TRUE(one.Passed()) << Describe(one);
  EXPECT_EQ(one.frames, test::RayScene::kFrames);
  EXPECT_EQ(Describe(one), Describe(CheckScene(rays(), 3)));
}

TEST_F(SceneCheckTest, AChangedByteAndAForeignFileAreDetected) {
  std::string times = ReadFileBytes(rays() / "times.txt");
  WriteFileBytes(rays() / "times.txt", times + "\n");
  WriteFileBytes(rays() / "notes.txt", "mine");
  const std::vector<SceneCheck> checks = CheckScene(rays(), 1).checks;
  EXPECT_THAT(Failed(checks), ElementsAre("manifest_changed_files", "manifest_unlisted_files"));
  EXPECT_THAT(checks[0].where, HasSubstr("times.txt"));
  EXPECT_EQ(checks[1].where, "notes.txt");
}

TEST_F(SceneCheckTest, AFileThatCannotBeReadIsAFailedCheck) {
  fs::remove(rays() / "instance_0/000002.png");
  EXPECT_THAT(FailedNow(), AllOf(Contains("masks_unreadable"), Not(Contains("baseline_error"))));
}

TEST_F(SceneCheckTest, AFolderWithoutASceneIsAnError) {
  EXPECT_THAT(ErrorMessage([&] { CheckScene(folder_.path(), 1); }), HasSubstr("no objects.csv"));
}

TEST_F(SceneCheckTest, AHorizontalShiftOfATenthOfAPixelIsFound) {
  EditAll("image_1", ".png", [](cv::Mat& image) { Shift(image, 0.1, 0.0); });
  EXPECT_THAT(FailedNow(), Contains("disparity_offset"));
}

TEST_F(SceneCheckTest, ARowShiftIsFound) {
  EditAll("image_1", ".png", [](cv::Mat& image) { Shift(image, 0.0, 0.1); });
  EXPECT_THAT(FailedNow(), AllOf(Contains("row_offset"), Not(Contains("disparity_offset"))));
}

TEST_F(SceneCheckTest, DepthOffByOnePerCentIsFound) {
  EditAll("depth_0", ".tiff", [](cv::Mat& depth) { depth *= 1.01; });
  EXPECT_THAT(FailedNow(), AllOf(Contains("disparity_offset"), Contains("mask_point_out_of_box")));
}

TEST_F(SceneCheckTest, SwappedMasksAreFound) {
  Edit("instance_0/000001.png", [](cv::Mat& instances) {
    cv::Mat swapped = instances.clone();
    swapped.setTo(2, instances == 1);
    swapped.setTo(1, instances == 2);
    instances = swapped;
  });
  EXPECT_THAT(FailedNow(), AllOf(Contains("mask_visible_px"), Contains("mask_visible_box"),
                                 Contains("mask_point_out_of_box")));
}

TEST_F(SceneCheckTest, AnUnknownBodyIdIsFound) {
  Edit("instance_0/000001.png", [](cv::Mat& instances) { instances.at<std::uint16_t>(3, 3) = 9; });
  EXPECT_THAT(FailedNow(), ElementsAre("mask_unknown_ids"));
}

TEST_F(SceneCheckTest, APerturbedCameraPoseIsFound) {
  std::vector<RigidTransform> poses = ReadKittiPoses(rays() / "poses.txt");
  poses[2].data()[4] += 0.005;
  WriteFileBytes(rays() / "poses.txt", FormatKittiPoses(poses));
  EXPECT_THAT(FailedNow(), Contains("baseline_error"));
}

TEST_F(SceneCheckTest, AWrongVelocityIsFound) {
  for (int i = 0; i < test::RayScene::kFrames; ++i) {
    Replace("objects.csv", ",0.5,0,0,0,0,1.428", ",0.7,0,0,0,0,1.428");
  }
  EXPECT_THAT(FailedNow(), ElementsAre("velocity_error"));
}

TEST_F(SceneCheckTest, ARotationThatDisagreesWithItsVelocityIsFound) {
  for (int i = 0; i < test::RayScene::kFrames; ++i) {
    const test::RayScene scene;
    const auto text = [&](const RigidTransform& pose) {
      std::string cells;
      const Eigen::Vector4d quaternion = pose.rotation().coeffs();
      for (const double value : quaternion) cells += FormatDouble(value) + ",";
      return cells;
    };
    Replace("objects.csv", text(scene.WorldFromObject(1, i)),
            text(RigidTransform(scene.WorldFromObject(1, 0).rotation(), Eigen::Vector3d::Zero())));
  }
  EXPECT_THAT(FailedNow(), Contains("angular_velocity_error"));
}

}  // namespace
}  // namespace cvo
