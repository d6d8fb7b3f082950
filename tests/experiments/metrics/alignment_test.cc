// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "experiments/metrics/trajectory.h"
#include "tests/support/error_message.h"

namespace cvo::alignment_test {
namespace {

const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

// True poses, and the same poses in the world of another system: truth = motion * estimate.
CommonPoses PosesMovedBy(const Similarity& motion) {
  Rng rng(3, "alignment");
  CommonPoses poses;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d rotation(rng.Normal(), rng.Normal(), rng.Normal());
    const RigidTransform estimate(ExpSo3(rotation),
                                  Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal()));
    poses.frames.push_back(i);
    poses.estimate.push_back(estimate);
    poses.truth.push_back(motion * estimate);
  }
  return poses;
}

double LargestError(const CommonPoses& poses, TrajectoryAlignment alignment) {
  const Similarity aligned = AlignTrajectory(poses, alignment, kUp);
  double largest = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const RigidTransform error = poses.truth[i].Inverse() * (aligned * poses.estimate[i]);
    largest = std::max(
        {largest, error.translation().norm(), RotationAngle(Eigen::Quaterniond(error.rotation()))});
  }
  return largest;
}

Similarity Motion(double scale, const Eigen::Vector3d& rotation) {
  return {scale, RigidTransform(ExpSo3(rotation), Eigen::Vector3d(4.0, -2.0, 7.0))};
}

TEST(TrajectoryAlignment, EachRemovesItsOwnTransformOnly) {
  using enum TrajectoryAlignment;
  const CommonPoses same = PosesMovedBy(Similarity{});
  const CommonPoses turned_flat = PosesMovedBy(Motion(1.0, 0.7 * kUp));
  const CommonPoses turned = PosesMovedBy(Motion(1.0, {0.4, -0.3, 0.9}));
  const CommonPoses scaled = PosesMovedBy(Motion(1.7, {0.4, -0.3, 0.9}));
  constexpr double kExact = 1e-9;
  constexpr double kSeen = 0.05;
  EXPECT_LT(LargestError(same, kNone), kExact);
  EXPECT_GT(LargestError(turned_flat, kNone), kSeen);
  EXPECT_LT(LargestError(turned_flat, kYaw), kExact);
  EXPECT_GT(LargestError(turned, kYaw), kSeen);
  EXPECT_LT(LargestError(turned, kSe3), kExact);
  EXPECT_LT(LargestError(turned, kOrigin), kExact);
  EXPECT_GT(LargestError(scaled, kSe3), kSeen);
  EXPECT_GT(LargestError(scaled, kOrigin), kSeen);
  EXPECT_LT(LargestError(scaled, kSim3), kExact);
}

TEST(TrajectoryAlignment, AStationaryTrajectoryDeterminesNoScale) {
  CommonPoses poses;
  poses.frames = {0, 1};
  poses.estimate.resize(2);
  poses.truth.resize(2);
  EXPECT_EQ(ErrorMessage([&] { AlignTrajectory(poses, TrajectoryAlignment::kSim3, kUp); }),
            "alignment sim3: found positions that determine no scale, expected a trajectory that "
            "moves");
  EXPECT_EQ(ErrorMessage([] { AlignTrajectory({}, TrajectoryAlignment::kSe3, kUp); }),
            "alignment: found no common poses, expected at least one");
}

// A straight path leaves the rotation about its axis undetermined, which must not appear as an
// error.
TEST(TrajectoryAlignment, OrientationsOfAStraightPathAreAlignedSeparately) {
  CommonPoses poses;
  const Eigen::Quaterniond rolled(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()));
  for (int i = 0; i < 4; ++i) {
    poses.frames.push_back(i);
    poses.truth.emplace_back(Eigen::Quaterniond::Identity(), Eigen::Vector3d(i, 0, 0));
    poses.estimate.emplace_back(rolled, Eigen::Vector3d(i, 0, 0));
  }
  for (const auto alignment : {TrajectoryAlignment::kSe3, TrajectoryAlignment::kSim3}) {
    const Similarity aligned = AlignTrajectory(poses, alignment, kUp);
    for (const double error : OrientationErrors(poses, alignment, aligned)) {
      EXPECT_NEAR(error, 0.0, 1e-9);
    }
  }
  for (const double error : OrientationErrors(poses, TrajectoryAlignment::kNone, {})) {
    EXPECT_NEAR(error, 0.5, 1e-12);
  }
}

TEST(TrajectoryAlignment, OriginAlignmentRotatesTheOrientations) {
  CommonPoses poses = PosesMovedBy(Motion(1.0, {0.4, -0.3, 0.9}));
  const auto origin = TrajectoryAlignment::kOrigin;
  poses.truth[3] = poses.truth[3] * RigidTransform(ExpSo3({0.0, 0.2, 0.0}), {0, 0, 0});
  const std::vector<double> errors =
      OrientationErrors(poses, origin, AlignTrajectory(poses, origin, kUp));
  for (std::size_t i = 0; i < errors.size(); ++i) {
    EXPECT_NEAR(errors[i], i == 3 ? 0.2 : 0.0, 1e-9) << i;
  }
}

}  // namespace
}  // namespace cvo::alignment_test

namespace cvo::association_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

constexpr std::int64_t kMs = 1'000'000;

Trajectory At(const std::vector<std::int64_t>& times_ms) {
  Trajectory trajectory;
  for (const std::int64_t time_ms : times_ms) {
    trajectory.push_back({time_ms * kMs,
                          {Eigen::Quaterniond::Identity(),
                           Eigen::Vector3d(static_cast<double>(time_ms), 0.0, 0.0)}});
  }
  return trajectory;
}

TEST(Association, NearestWinsAndIsOneToOne) {
  // 12 is nearest to 10, so 2 stays unmatched although 10 is within its tolerance.
  const TimeAssociation a = AssociateByTime(At({2, 12}), At({10}));
  EXPECT_THAT(a.pairs, ElementsAre(Pair(1, 0)));
  EXPECT_EQ(a.unmatched_a, 1u);
  EXPECT_EQ(a.unmatched_b, 0u);
}

TEST(Association, PosesLandOnTheirFrames) {
  const Trajectory estimate = At({1, 201});
  const auto poses = PosesAtFrames(AssociateByTime(At({0, 100, 200}), estimate), 3, estimate);
  ASSERT_EQ(poses.size(), 3u);
  EXPECT_EQ(poses[0]->translation().x(), 1.0);
  EXPECT_FALSE(poses[1].has_value());
  EXPECT_EQ(poses[2]->translation().x(), 201.0);
}

TEST(Association, ToleranceIsInclusiveOnBothSides) {
  EXPECT_THAT(AssociateByTime(At({20}), At({0})).pairs, ElementsAre(Pair(0, 0)));
  EXPECT_THAT(AssociateByTime(At({21}), At({0})).pairs, IsEmpty());
  EXPECT_THAT(AssociateByTime(At({100, 200}), At({0, 50, 81, 110, 300})).pairs,
              ElementsAre(Pair(0, 3)));
}

}  // namespace
}  // namespace cvo::association_test
