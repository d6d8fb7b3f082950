// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/clock_offset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/rng.h"
#include "tests/support/error_message.h"

namespace cvo::clock_offset_test {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kDuration_s = 20.0;
const RigidTransform kOtherWorld(ExpSo3({0.4, -0.9, 0.7}), {0.3, -0.2, 0.5});

using Motion = std::function<RigidTransform(double t_s)>;

// The motion of a hand-held camera: its frequencies have no common period.
RigidTransform Shaken(double t_s) {
  return {ExpSo3({0.3 * std::sin(2.1 * t_s), 0.4 * std::sin(3.7 * t_s + 1.0),
                  0.2 * std::cos(5.3 * t_s)}),
          {0.2 * std::sin(1.3 * t_s), 0.0, 0.1 * t_s}};
}

// Records poses at the motion times start_s, start_s + 1 / rate_hz, ..., with the timestamps of a
// clock that is `ahead_s` ahead of the motion time.
Trajectory Record(const Motion& motion, double rate_hz, double start_s, double ahead_s) {
  Trajectory trajectory;
  const int poses = static_cast<int>(kDuration_s * rate_hz);
  for (int i = 0; i < poses; ++i) {
    const double t_s = start_s + i / rate_hz;
    trajectory.push_back({std::llround(1e9 * (t_s + ahead_s)), motion(t_s)});
  }
  return trajectory;
}

// Moves a trajectory to another world and adds rotation errors between frames, which accumulate
// like those of odometry.
Trajectory WithDrift(Trajectory trajectory, double deviation_rad, std::uint64_t seed) {
  Rng rng(seed, "drift");
  RigidTransform error;
  for (TimedPose& pose : trajectory) {
    error = error * RigidTransform(
                        ExpSo3(deviation_rad * Vector3d(rng.Normal(), rng.Normal(), rng.Normal())),
                        Vector3d::Zero());
    pose.world_from_camera = kOtherWorld * pose.world_from_camera * error;
  }
  return trajectory;
}

std::string Refused(const Motion& motion, double most_s) {
  const Trajectory truth = Record(motion, 200.0, -1.0, 0.1);
  return ErrorMessage([&] {
    EstimateClockOffset(truth, WithDrift(Record(motion, 15.0, 0.0, 0.0), 1e-4, 1), most_s);
  });
}

TEST(ClockOffset, IsFoundForTruthOfHighAndLowRate) {
  for (const double ahead_s : {-0.73, -0.004, 0.0, 0.137, 0.8}) {
    const Trajectory estimate = WithDrift(Record(Shaken, 15.0, 0.0, 0.0), 0.0, 1);
    const ClockOffset fast =
        EstimateClockOffset(Record(Shaken, 200.0, -1.003, ahead_s), estimate, 1.0);
    EXPECT_NEAR(fast.offset_s, ahead_s, 2e-4);
    EXPECT_LT(fast.deviation_s, 1e-3);
    EXPECT_GT(fast.explained, 0.999);
    const ClockOffset slow =
        EstimateClockOffset(Record(Shaken, 15.0, -1.003, ahead_s), estimate, 1.0);
    EXPECT_NEAR(slow.offset_s, ahead_s, 5e-3);
    EXPECT_EQ(slow.offset_s,
              EstimateClockOffset(Record(Shaken, 15.0, -1.003, ahead_s), estimate, 1.0).offset_s);
  }
}

// Errors normalised by the reported deviation are standard normal: 95 % are within 1.96.
TEST(ClockOffset, ItsDeviationIsConsistent) {
  constexpr int kRuns = 100;
  constexpr double kAhead_s = 0.0321;
  const Trajectory truth = Record(Shaken, 200.0, -1.0, kAhead_s);
  int within = 0;
  double squares = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const ClockOffset clock = EstimateClockOffset(
        truth, WithDrift(Record(Shaken, 15.0, 0.0, 0.0), 5e-3, static_cast<std::uint64_t>(run)),
        0.2);
    const double normalised = (clock.offset_s - kAhead_s) / clock.deviation_s;
    within += std::abs(normalised) < 1.96 ? 1 : 0;
    squares += normalised * normalised;
  }
  EXPECT_GE(within, 88);
  EXPECT_LE(within, 100);
  EXPECT_NEAR(squares / kRuns, 1.0, 0.4);
}

TEST(ClockOffset, IsRefusedIfTheMotionDoesNotDetermineIt) {
  EXPECT_THAT(Refused(
                  [](double t_s) {
                    return RigidTransform(ExpSo3({0, 0.2 * t_s, 0}), Vector3d::Zero());
                  },
                  1),
              HasSubstr("back and forth"));
  EXPECT_THAT(Refused(
                  [](double t_s) {
                    return RigidTransform(Eigen::Quaterniond::Identity(), Vector3d(t_s, 0, 0));
                  },
                  1),
              HasSubstr("the truth explains"));
  const auto swinging = [](double t_s) {
    return RigidTransform(ExpSo3({0, 0.3 * std::sin(12.0 * t_s), 0}), Vector3d::Zero());
  };
  EXPECT_THAT(Refused(swinging, 1), HasSubstr("motions that do not repeat"));
  EXPECT_EQ(Refused(swinging, 0.2), "");
  EXPECT_THAT(Refused(Shaken, 0.05), HasSubstr("the end of the search"));
}

TEST(ClockOffset, IsRefusedIfTheTimesOverlapTooLittle) {
  const Trajectory estimate = Record(Shaken, 15.0, 0.0, 0.0);
  EXPECT_THAT(
      ErrorMessage([&] { EstimateClockOffset(Record(Shaken, 200.0, 0.0, 15.0), estimate, 1.0); }),
      HasSubstr("too few of them within the truth"));
  EXPECT_THAT(ErrorMessage([&] { EstimateClockOffset({}, {}, 1.0); }),
              HasSubstr("0 pairs of poses"));
}

// The estimate has 300 poses at 15 Hz from time 0 on; the truth covers 20 s, from -1 s to 19 s.
TEST(ClockOffset, ReportsItsPairsAndResidual) {
  const Trajectory estimate = Record(Shaken, 15.0, 0.0, 0.0);
  const ClockOffset clock = EstimateClockOffset(Record(Shaken, 200.0, -1.0, 0.0), estimate, 0.2);
  EXPECT_EQ(clock.pairs, 284U) << "the last within the truth ends at 284 / 15 s";
  // Independent noise of a pose enters two steps of 1/15 s each.
  Trajectory noisy = estimate;
  Rng rng(3, "noise");
  for (TimedPose& pose : noisy) {
    const Vector3d turn(rng.Normal(), rng.Normal(), rng.Normal());
    pose.world_from_camera =
        pose.world_from_camera * RigidTransform(ExpSo3(0.01 * turn), {0, 0, 0});
  }
  const ClockOffset rough = EstimateClockOffset(Record(Shaken, 200.0, -1.0, 0.0), noisy, 0.2);
  EXPECT_NEAR(rough.residual_rad_per_s, 0.01 * std::sqrt(2.0) * 15.0, 0.02);
  EXPECT_NEAR(rough.explained, 0.93, 0.02);
}

TEST(ClockOffset, NamesTheSearchLimitThatItExceeds) {
  for (const double ahead_s : {-0.08, 0.08}) {
    const Trajectory truth = Record(Shaken, 200.0, -1.0, ahead_s);
    const Trajectory estimate = Record(Shaken, 15.0, 0.0, 0.0);
    EXPECT_THAT(ErrorMessage([&] { EstimateClockOffset(truth, estimate, 0.05); }),
                HasSubstr(ahead_s < 0.0 ? "found the best agreement at -0.05 s"
                                        : "found the best agreement at 0.05 s"));
    EXPECT_NEAR(EstimateClockOffset(truth, estimate, 0.09).offset_s, ahead_s, 2e-4);
  }
}

}  // namespace
}  // namespace cvo::clock_offset_test
