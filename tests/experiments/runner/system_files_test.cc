// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/system_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/runner/system_drive.h"
#include "tests/support/error_message.h"

namespace cvo::system_files_test {
namespace {

using test::kDriveFrames;
using test::Rows;
using test::SystemDrive;
using test::ValueOf;
using testing::AllOf;
using testing::HasSubstr;

std::string KittiCamera(int begin = 0, int end = kDriveFrames) {
  std::vector<RigidTransform> poses;
  for (int frame = begin; frame < end; ++frame) {
    poses.push_back(SystemDrive::World() * test::DriveCamera(frame));
  }
  return FormatKittiPoses(poses);
}

// Keeps only frames 2 to 5.
void KeepPart(Sequence& sequence) {
  sequence.first_frame = 2;
  const auto keep = [](auto& values) {
    values.erase(values.begin() + 6, values.end());
    values.erase(values.begin(), values.begin() + 2);
  };
  keep(sequence.images);
  keep(sequence.timestamps_ns);
  keep(sequence.groundtruth_world_from_camera);
  std::erase_if(sequence.labels,
                [](const ObjectBox& box) { return box.frame < 2 || box.frame > 5; });
}

TEST(SystemFiles, AKittiCameraHasALinePerFrame) {
  const SystemDrive drive;
  const SystemOutcome outcome = drive.Score(Rows(), KittiCamera());
  EXPECT_LT(ValueOf(outcome, "camera_ate"), 1e-9);
  EXPECT_LT(ValueOf(outcome, "object_ate"), 1e-9);
}

TEST(SystemFiles, FramesOutsideTheRangeAreIgnored) {
  SystemDrive drive;
  KeepPart(drive.sequence());
  for (const std::string& camera :
       {FormatTumTrajectory(SystemDrive::Camera()), KittiCamera(), KittiCamera(2, 6)}) {
    const SystemOutcome outcome = drive.Score(Rows(), camera);
    EXPECT_EQ(outcome.object_frames, 8);
    EXPECT_EQ(ValueOf(outcome, "camera_coverage"), 1.0);
    EXPECT_EQ(ValueOf(outcome, "object_coverage"), 1.0);
    EXPECT_LT(ValueOf(outcome, "camera_ate"), 1e-9);
    EXPECT_LT(ValueOf(outcome, "object_ate"), 1e-9);
  }
}

TEST(SystemFiles, RowsMayComeInAnyOrder) {
  const SystemDrive drive;
  const auto only = [](int track) {
    return Rows([track](const test::ReportedBox& said, int) {
      return said.track == track ? std::optional(said) : std::nullopt;
    });
  };
  EXPECT_EQ(ValueOf(drive.Score(only(1) + only(0)), "object_coverage"), 1.0);
}

class BadFiles : public testing::Test {
 protected:
  std::string Camera(const std::string& camera) const {
    return ErrorMessage([&] { drive_.Score("none", camera); });
  }
  std::string Objects(const std::string& rows) const {
    return ErrorMessage([&] { drive_.Score(rows); });
  }
  // The rows with the first `from` replaced by `to`.
  static std::string Changed(const std::string& from, const std::string& to) {
    std::string rows = Rows();
    rows.replace(rows.find(from), from.size(), to);
    return rows;
  }

  SystemDrive drive_;
};

TEST_F(BadFiles, Cameras) {
  const std::string tum = FormatTumTrajectory(SystemDrive::Camera());
  EXPECT_THAT(Camera(tum + "0.95 0 0 0 0 0 0 1\n"),
              AllOf(HasSubstr("camera.txt:9: "), HasSubstr("0.95"), HasSubstr("a frame")));
  EXPECT_THAT(Camera("# of another start\n" + tum + "99 0 0 0 0 0 0 1\n"),
              HasSubstr("camera.txt:10: "));
  EXPECT_THAT(Camera("0.1 0 0 0 0 0 0 1\n0.11 0 0 0 0 0 0 1\n"), HasSubstr("camera.txt:2: "));
  EXPECT_THAT(Camera("0.1 0 0 0 0 0 0 1\n0.0 0 0 0 0 0 0 1\n"), HasSubstr("camera.txt:2: "));
  EXPECT_THAT(Camera("0.1 0 nan 0 0 0 0 1\n"), HasSubstr("camera.txt:1: "));
  EXPECT_THAT(Camera("0.1 0 0 0 0 0 0 1\n"), HasSubstr("found 1 poses"));
  EXPECT_THAT(Camera(""), HasSubstr("no pose"));
  EXPECT_THAT(Camera(KittiCamera(0, 7)),
              AllOf(HasSubstr("camera.txt:7: "), HasSubstr("7 poses"), HasSubstr("8, one per")));
  EXPECT_THAT(ErrorMessage([&] {
                ReadSystem(drive_.sequence(), {"other", "/no/such/camera", {}});
              }),
              HasSubstr("/no/such/camera"));
}

TEST_F(BadFiles, Objects) {
  EXPECT_THAT(Objects(""), AllOf(HasSubstr("tracks.txt:1: "), HasSubstr("DontCare")));
  EXPECT_THAT(Objects(Rows() + Rows()),
              AllOf(HasSubstr("tracks.txt:17: "), HasSubstr("tracks.txt:1")));
  EXPECT_THAT(Objects(Changed("3 1 Car", "8 1 Car")),
              AllOf(HasSubstr("tracks.txt:8: "), HasSubstr("frame 8"), HasSubstr("0 to 7")));
  EXPECT_THAT(Objects(Changed("3 1 Car", "3 -1 Car")),
              AllOf(HasSubstr("tracks.txt:8: "), HasSubstr("track -1")));
  EXPECT_THAT(Objects(Changed(" 1.5 1.8", " -1 1.8")),
              AllOf(HasSubstr("tracks.txt:1: "), HasSubstr("3D box")));
  EXPECT_THAT(Objects(Changed(" 1.5 1.8", " inf 1.8")), HasSubstr("tracks.txt:1: "));
  EXPECT_THAT(Objects("0 1 Car\n"), HasSubstr("tracks.txt:1: "));
}

TEST_F(BadFiles, FoldersOfObjects) {
  const auto objects = [&] {
    const auto camera =
        drive_.folder().Write("camera.tum", FormatTumTrajectory(SystemDrive::Camera()));
    return ErrorMessage([&] {
      ReadSystem(drive_.sequence(), {"other", camera, drive_.folder().path() / "objects"});
    });
  };
  EXPECT_THAT(objects(), HasSubstr("objects"));
  drive_.folder().Write("objects/readme.txt", "");
  EXPECT_THAT(objects(), HasSubstr("<id>.tum"));
  drive_.folder().Write("objects/1.tum", "0.1 0 0 0 0 0 0 1\n9 0 0 0 0 0 0 1\n");
  EXPECT_THAT(objects(), HasSubstr("1.tum:2: "));
  drive_.folder().Write("objects/1.tum", "0.1 0 0 0 0 0 0 1\n");
  EXPECT_EQ(objects(), "");
  drive_.folder().Write("objects/car.tum", "0.1 0 0 0 0 0 0 1\n");
  EXPECT_THAT(objects(), HasSubstr("car.tum"));
}

}  // namespace
}  // namespace cvo::system_files_test
