// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/student.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

// Closed forms for one to four degrees of freedom.
TEST(Student, TailOfFewDegrees) {
  for (const double t : {0.0, 0.3, 1.0, 2.5, 40.0}) {
    const double theta1 = std::atan(t);
    EXPECT_NEAR(StudentTail(t, 1), 0.5 - theta1 / std::numbers::pi, 1e-14) << t;
    EXPECT_NEAR(StudentTail(t, 2), 0.5 - 0.5 * t / std::sqrt(2.0 + t * t), 1e-14) << t;
    const double theta3 = std::atan(t / std::sqrt(3.0));
    EXPECT_NEAR(StudentTail(t, 3),
                0.5 - (theta3 + std::sin(theta3) * std::cos(theta3)) / std::numbers::pi, 1e-14)
        << t;
    const double sine4 = t / std::sqrt(4.0 + t * t);
    EXPECT_NEAR(StudentTail(t, 4), 0.5 - 0.25 * sine4 * (3.0 - sine4 * sine4), 1e-14) << t;
  }
}

// Values of printed tables, two-sided at 5 % and at 1 %.
TEST(Student, QuantilesMatchTables) {
  for (const auto& [degrees, at_5, at_1] : {std::tuple(1, 12.706, 63.657),
                                            {2, 4.303, 9.925},
                                            {3, 3.182, 5.841},
                                            {5, 2.571, 4.032},
                                            {6, 2.447, 3.707},
                                            {10, 2.228, 3.169},
                                            {29, 2.045, 2.756},
                                            {120, 1.980, 2.617}}) {
    EXPECT_NEAR(StudentQuantile(0.025, degrees), at_5, 6e-4) << degrees;
    EXPECT_NEAR(StudentQuantile(0.005, degrees), at_1, 6e-4) << degrees;
  }
}

TEST(Student, QuantileIsTheInverseOfTheTail) {
  for (const int degrees : {1, 2, 7, 8, 400}) {
    for (const double tail : {1e-9, 1e-3, 0.2, 0.49}) {
      const double t = StudentQuantile(tail, degrees);
      EXPECT_NEAR(StudentTail(t, degrees) / tail, 1.0, 1e-6) << degrees << " " << tail;
    }
    EXPECT_NEAR(StudentQuantile(0.5, degrees), 0.0, 1e-12);
  }
}

TEST(Student, DegreesOfFreedomAreCappedAtAThousand) {
  EXPECT_EQ(StudentTail(2.0, 1001), StudentTail(2.0, 1000));
  EXPECT_EQ(StudentQuantile(0.1, 1'000'000), StudentQuantile(0.1, 1000));
  EXPECT_NE(StudentTail(2.0, 999), StudentTail(2.0, 1000));
  EXPECT_NEAR(StudentTail(2.0, 1000), 0.0227501, 2e-4) << "of the normal distribution";
}

TEST(Student, TailIsNeverNegative) {
  for (const int degrees : {1, 2, 9, 50, 1000}) {
    for (double t = 1.0; t < 1e8; t *= 1.7) EXPECT_GE(StudentTail(t, degrees), 0.0);
  }
}

TEST(Student, RefusesInvalidArguments) {
  EXPECT_THROW(StudentTail(-0.1, 3), Error);
  EXPECT_THROW(StudentTail(1.0, 0), Error);
  EXPECT_THROW(StudentQuantile(0.1, 0), Error);
  EXPECT_THROW(StudentQuantile(5e-10, 3), Error);
  EXPECT_THROW(StudentQuantile(0.51, 3), Error);
}

}  // namespace
}  // namespace cvo::reports
