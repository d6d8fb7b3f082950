// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/metrics/trajectory.h"
#include "tests/support/error_message.h"

namespace cvo::association_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
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

TEST(Association, EqualTimesPairUp) {
  const TimeAssociation a = AssociateByTime(At({0, 100, 200}), At({0, 100, 200}));
  EXPECT_THAT(a.pairs, ElementsAre(Pair(0, 0), Pair(1, 1), Pair(2, 2)));
  EXPECT_EQ(a.unmatched_a, 0u);
  EXPECT_EQ(a.unmatched_b, 0u);
}

TEST(Association, ToleranceIsInclusive) {
  EXPECT_THAT(AssociateByTime(At({0}), At({20})).pairs, ElementsAre(Pair(0, 0)));
  const TimeAssociation none = AssociateByTime(At({0}), At({21}));
  EXPECT_THAT(none.pairs, IsEmpty());
  EXPECT_EQ(none.unmatched_a, 1u);
  EXPECT_EQ(none.unmatched_b, 1u);
  EXPECT_THAT(AssociateByTime(At({0, 5}), At({5}), 0).pairs, ElementsAre(Pair(1, 0)));
}

TEST(Association, NearestWinsAndIsOneToOne) {
  // 12 is nearest to 10, so 2 stays unmatched although 10 is within its tolerance.
  const TimeAssociation a = AssociateByTime(At({2, 12}), At({10}));
  EXPECT_THAT(a.pairs, ElementsAre(Pair(1, 0)));
  EXPECT_EQ(a.unmatched_a, 1u);
  EXPECT_EQ(a.unmatched_b, 0u);
}

TEST(Association, TiesGoToTheFirst) {
  EXPECT_THAT(AssociateByTime(At({0, 20}), At({10})).pairs, ElementsAre(Pair(0, 0)));
  EXPECT_THAT(AssociateByTime(At({10}), At({0, 20})).pairs, ElementsAre(Pair(0, 0)));
}

TEST(Association, SecondChoiceIsTakenWhenTheFirstIsGone) {
  // 13 takes 12, so 10 is paired with 2.
  const TimeAssociation a = AssociateByTime(At({10, 13}), At({2, 12}));
  EXPECT_THAT(a.pairs, ElementsAre(Pair(0, 0), Pair(1, 1)));
}

TEST(Association, NothingToPair) {
  const TimeAssociation a = AssociateByTime(At({}), At({1, 2}));
  EXPECT_THAT(a.pairs, IsEmpty());
  EXPECT_EQ(a.unmatched_a, 0u);
  EXPECT_EQ(a.unmatched_b, 2u);
}

TEST(Association, RefusesTimesThatDoNotIncrease) {
  EXPECT_THAT(ErrorMessage([] {
                AssociateByTime(At({1, 1}), At({1}));
              }),
              HasSubstr("timestamps must increase"));
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

TEST(Association, RefusesANegativeTolerance) {
  EXPECT_THAT(ErrorMessage([] { AssociateByTime(At({0}), At({0}), -1); }), HasSubstr("tolerance"));
  EXPECT_THAT(ErrorMessage([] {
                AssociateByTime(At({0}), At({0, 3, 2}), 0);
              }),
              HasSubstr("timestamps must increase"));
}

TEST(Association, RefusesPairsOfOtherTrajectories) {
  const Trajectory estimate = At({1, 2});
  const auto refused = [&](std::size_t frame, std::size_t index) {
    return ErrorMessage([&] { PosesAtFrames({{{frame, index}}, 0, 0}, 3, estimate); });
  };
  EXPECT_EQ(refused(2, 1), "");
  EXPECT_THAT(refused(3, 1), HasSubstr("out of range"));
  EXPECT_THAT(refused(2, 2), HasSubstr("out of range"));
}

}  // namespace
}  // namespace cvo::association_test
