// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include "experiments/metrics/trajectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/base/rng.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::trajectory_files_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

RigidTransform RandomPose(Rng& rng) {
  const Eigen::Vector3d rotation(rng.Normal(), rng.Normal(), rng.Normal());
  const Eigen::Vector3d translation(rng.Normal(), 100.0 * rng.Normal(), 1e-5 * rng.Normal());
  return {ExpSo3(rotation), translation};
}

TEST(Trajectory, InterpolatesPositionsAndRotations) {
  const Trajectory poses = {{100, {ExpSo3({0, 0, 0}), {0, 0, 0}}},
                            {200, {ExpSo3({0, 0, 0.4}), {1, 0, 0}}},
                            {400, {ExpSo3({0, 0, 0.8}), {3, 2, 0}}}};
  EXPECT_FALSE(InterpolatePose(poses, 99).has_value());
  EXPECT_FALSE(InterpolatePose(poses, 401).has_value());
  for (const TimedPose& pose : poses) {
    EXPECT_EQ(InterpolatePose(poses, pose.timestamp_ns)->Matrix(), pose.world_from_camera.Matrix());
  }
  const RigidTransform quarter = *InterpolatePose(poses, 125);
  EXPECT_NEAR(quarter.translation().x(), 0.25, 1e-15);
  EXPECT_NEAR(RotationAngle(quarter.rotation()), 0.1, 1e-12);
  EXPECT_NEAR(InterpolatePose(poses, 300)->translation().y(), 1.0, 1e-15);
  EXPECT_FALSE(InterpolatePose({}, 0).has_value());
}

class TumTrajectory : public testing::Test {
 protected:
  Trajectory Read(const std::string& text) {
    return ReadTrajectory(folder_.Write("trajectory.txt", text)).poses;
  }
  std::string ReadError(const std::string& text) {
    return ErrorMessage([&] { Read(text); });
  }
  test::TempFolder folder_;
};

TEST_F(TumTrajectory, ReadsPosesAndComments) {
  const Trajectory t = Read(
      "# timestamp tx ty tz qx qy qz qw\n"
      "\n"
      "1305031102.175304 1 2 3 0 0 0 1\r\n"
      "  #another comment\n"
      "1305031102.211214001\t-1.5e-3 0 0 0 0 0.70710678 0.70710678");
  ASSERT_EQ(t.size(), 2u);
  EXPECT_EQ(t[0].timestamp_ns, 1305031102175304000);
  EXPECT_EQ(t[0].world_from_camera.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(t[1].timestamp_ns, 1305031102211214001);
  EXPECT_NEAR(t[1].world_from_camera.rotation().norm(), 1.0, 1e-15);
  EXPECT_NEAR(RotationAngle(t[1].world_from_camera.rotation()), std::numbers::pi / 2, 1e-12);
}

TEST_F(TumTrajectory, RoundTripIsExact) {
  Rng rng(1, "tum");
  Trajectory written;
  std::int64_t time_ns = 1'305'031'102'000'000'001;
  for (int i = 0; i < 200; ++i) {
    time_ns += 1 + static_cast<std::int64_t>(rng.UniformInt(1'000'000'000));
    written.push_back({time_ns, RandomPose(rng)});
  }
  const std::filesystem::path path = folder_.path() / "round_trip.txt";
  WriteFileBytes(path, FormatTumTrajectory(written));
  const Trajectory read = ReadTrajectory(path).poses;
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].timestamp_ns, written[i].timestamp_ns);
    for (int k = 0; k < 7; ++k) {
      EXPECT_EQ(read[i].world_from_camera.data()[k], written[i].world_from_camera.data()[k]);
    }
  }
  EXPECT_EQ(FormatTumTrajectory(read), ReadFileBytes(path));
}

TEST_F(TumTrajectory, RefusesWrongColumns) {
  EXPECT_THAT(ReadError("# c\n1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0\n"),
              AllOf(HasSubstr("trajectory.txt:3: found 7 columns"), HasSubstr("expected 8")));
  EXPECT_THAT(ReadError("1 0 0 0 0 0 0 1 9\n"), HasSubstr(":1: found 9 columns"));
  EXPECT_THAT(ReadError("0 1 0 0 4 0 1 0 5 0 0 1 6\n"), HasSubstr("12 for KITTI's poses"));
  EXPECT_THAT(ReadError("1 2 3 4\n2 2 3 4 0 0 0 1\n"), HasSubstr(":2: found 8 columns"));
  EXPECT_THAT(ReadError("1 0 0 0 0 0 0 1\n2 0 0"), HasSubstr("last line without a line end"));
}

TEST_F(TumTrajectory, RefusesInvalidNumbers) {
  EXPECT_THAT(ReadError("1 0 0 1e999 0 0 0 1\n"), HasSubstr("\"1e999\" in column 4"));
  EXPECT_THAT(ReadError("1 0 0 1,5 0 0 0 1\n"), HasSubstr("\"1,5\" in column 4"));
  EXPECT_THAT(ReadError("noon 0 0 0 0 0 0 1\n"),
              AllOf(HasSubstr("\"noon\" in column 1"), HasSubstr("a time")));
}

TEST_F(TumTrajectory, RefusesNonUnitQuaternions) {
  EXPECT_THAT(ReadError("1 0 0 0 0 0 0 1.06\n"),
              AllOf(HasSubstr(":1: found a quaternion of length 1.06"), HasSubstr("length 1")));
  EXPECT_THAT(ReadError("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 0\n"), HasSubstr(":2: found"));
  EXPECT_EQ(Read("1 0 0 0 0 0 0 1.01\n").size(), 1u);
}

TEST_F(TumTrajectory, RefusesTimesThatDoNotIncrease) {
  EXPECT_THAT(ReadError("1 0 0 0 0 0 0 1\n1.0 0 0 0 0 0 0 1\n"),
              AllOf(HasSubstr(":2: found time \"1.0\""), HasSubstr("after 1.000000000")));
  EXPECT_THAT(ReadError("2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n"), HasSubstr(":2: found time \"1\""));
}

// The same two poses as programs of the field write them.
TEST_F(TumTrajectory, ReadsOtherSpellingsOfThePoses) {
  const Trajectory expected = Read("1403636579.5 1 2 3 0 0.6 0 0.8\n1403636579.6 4 5 6 0 0 0 1\n");
  for (const char* text :
       {"\xEF\xBB\xBF"
        "1403636579.5 1 2 3 0 0.6 0 0.8\n1403636579.6 4 5 6 0 0 0 1\n",
        "1403636579500 1 2 3 0 0.6 0 0.8\n1403636579600 4 5 6 0 0 0 1\n",
        "1403636579500000000.0 1 2 3 0 0.6 0 0.8\n1403636579600000000.0 4 5 6 0 0 0 1\n",
        "timestamp,tx,ty,tz,qx,qy,qz,qw\n1403636579.5,1,2,3,0,0.6,0,0.8\n1403636579.6,4,5,6,0,0,0,"
        "1\n",
        "\xEF\xBB\xBFtime tx ty tz qx qy qz qw\n1403636579.5 1 2 3 0 0.6 0 0.8\n1403636579.6 4 5 6 "
        "0 0 0 1\n",
        "t x y z qw qx qy qz\n1403636579.5 1 2 3 0.8 0 0.6 0\n1403636579.6 4 5 6 1 0 0 0\n",
        "t;x;y;z;qx;qy;qz;qw\n1403636579.5;1;2;3;0;0.6;0;0.8\n1403636579.6;4;5;6;0;0;0;1\n",
        "#time [ns], p_x [m], p_y [m], p_z [m], q_w [], q_x [], q_y [], q_z [], v_x [m s^-1]\n"
        "1403636579500000000,1,2,3,0.8,0,0.6,0,9\n1403636579600000000,4,5,6,1,0,0,0,9\n",
        "1403636579500000000,1,2,3,0.8,0,0.6,0,\n1403636579600000000,4,5,6,1,0,0,0,\n"}) {
    const Trajectory read = Read(text);
    ASSERT_EQ(read.size(), 2u) << text;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(read[i].timestamp_ns, expected[i].timestamp_ns) << text;
      EXPECT_EQ(read[i].world_from_camera.Matrix(), expected[i].world_from_camera.Matrix()) << text;
    }
  }
}

TEST_F(TumTrajectory, LeavesOutRowsOfNan) {
  const auto path = folder_.Write("nan.txt",
                                  "1 0 0 0 0 0 0 1\n2 nan nan nan 0 0 0 1\n3 1 0 0 0 0 0.6 0.8\n"
                                  "4 -nan 0 0 0 0 0 1\n5 0 0 -inf 0 0 0 1\n");
  const TrajectoryFile file = ReadTrajectory(path);
  EXPECT_THAT(file.left_out, testing::ElementsAre(2, 4, 5));
  EXPECT_THAT(file.lines, testing::ElementsAre(1, 3));
  EXPECT_TRUE(file.has_rotations);
}

TEST_F(TumTrajectory, PositionsAloneTellNoRotations) {
  for (const char* q : {"", "0 0 0 0", "0 0 0 1", "0 0.6 0 0.8"}) {
    std::string text;
    for (const char* row : {"1 0 0 0 ", "2 1 0 0 ", "3 2 1 0 "})
      text += std::string(row) + q + "\n";
    EXPECT_FALSE(ReadTrajectory(folder_.Write("positions.txt", text)).has_rotations) << q;
  }
}

TEST(TimeUnit, FollowsFromTheClockOrTheStep) {
  const auto unit = [](const char* first, const char* second) {
    return std::string(TimeUnitOf({first, second}, 10.0).name);
  };
  EXPECT_EQ(unit("1400000000", "1400000000.1"), "s");
  EXPECT_EQ(unit("0", "5"), "s") << "keyframes";
  EXPECT_EQ(unit("0", "33"), "ms");
  EXPECT_EQ(unit("1400000000000", "1400000000005"), "ms");
  EXPECT_EQ(unit("0", "5e4"), "us");
  EXPECT_EQ(unit("1400000000000000", "1400000000000005"), "us");
  EXPECT_EQ(unit("0", "50000000"), "ns");
  EXPECT_EQ(unit("1400000000000000000", "1400000000000000256"), "ns");
}

TEST_F(TumTrajectory, KittiFilesAreToldByTheirColumns) {
  const std::string tum = "1.5 0 0 0 0 0 0 1\n";
  const std::string kitti = "1 0 0 4 0 1 0 5 0 0 1 6\n";
  const auto is_kitti = [&](const std::string& text) {
    return IsKittiPoseFile(folder_.Write("poses.txt", text));
  };
  EXPECT_TRUE(is_kitti("# 1 2 3\n\n" + kitti + tum));
  EXPECT_FALSE(is_kitti("\n  #4 5\n" + tum));
  EXPECT_FALSE(is_kitti("1 2 3 4 5 6 7 8 9 10 11 12 13\n"));
}

class KittiPoses : public TumTrajectory {
 protected:
  std::vector<RigidTransform> ReadPoses(const std::string& text) {
    return ReadKittiPoses(folder_.Write("poses.txt", text));
  }
  std::string PosesError(const std::string& text) {
    return ErrorMessage([&] { ReadPoses(text); });
  }
};

TEST_F(KittiPoses, RoundTripKeepsPoses) {
  Rng rng(2, "kitti");
  std::vector<RigidTransform> written;
  for (int i = 0; i < 100; ++i) written.push_back(RandomPose(rng));
  const std::filesystem::path path = folder_.path() / "poses.txt";
  WriteFileBytes(path, FormatKittiPoses(written));
  const std::vector<RigidTransform> read = ReadKittiPoses(path);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].translation(), written[i].translation());
    EXPECT_LT(read[i].Minus(written[i]).norm(), 1e-14);
  }
}

TEST_F(KittiPoses, OrthonormalisesRotationsOfSevenDigits) {
  const auto poses = ReadPoses(
      "9.999995e-01 7.196824e-04 -6.870876e-04 -1.401751e-02 -7.197717e-04 9.999997e-01 "
      "-1.295633e-04 -2.820321e-02 6.869946e-04 1.300585e-04 9.999998e-01 1.198998e+00\n");
  const Eigen::Matrix3d R = poses[0].RotationMatrix();
  EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_NEAR(R(0, 1), 7.196824e-04, 1e-9);
}

TEST_F(KittiPoses, RefusesBadRows) {
  EXPECT_THAT(PosesError("1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1\n"),
              AllOf(HasSubstr("poses.txt:2: found 11 columns"), HasSubstr("expected 12")));
  EXPECT_THAT(PosesError("1 0 0 0 0 1 0 0 0 0 1 nan\n"), HasSubstr("\"nan\" in column 12"));
  EXPECT_THAT(PosesError("1 0 0 0 0 1 0 0 0 0 1.1 0\n"),
              AllOf(HasSubstr("poses.txt:1: found a matrix"), HasSubstr("expected a rotation")));
  EXPECT_THAT(PosesError("1 0 0 0 0 1 0 0 0 0 -1 0\n"), HasSubstr("found a reflection"));
  EXPECT_THAT(PosesError("1 0 0 0 0 1 0 0 0 0 1 0\n\n1 0 0 0 0 1 0 0 0 0 1 0\n"),
              HasSubstr(":2: found 0 columns"));
}

}  // namespace
}  // namespace cvo::trajectory_files_test
