// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/motion/curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "synth/motion/speed_profile.h"
#include "tests/support/error_message.h"

namespace cvo::synth::curve_test {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

std::vector<Vector3d> Bent() { return {{0, 0, 0}, {2, 0.5, 0}, {3, 2, 0}, {2.5, 4, 0}, {0, 5, 0}}; }
std::vector<Vector3d> Square() { return {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}; }

std::vector<Curve> Curves() {
  return {Curve::Through(Bent(), false, ""), Curve::Through(Square(), true, ""),
          Curve::Rounded(Bent(), false, 0.6, ""), Curve::Rounded(Square(), true, 1.0, "")};
}

TEST(Curve, PassesThroughItsPoints) {
  const Curve curve = Curve::Through(Bent(), false, "");
  for (const Vector3d& point : Bent()) {
    double nearest = 1e9;
    for (double s = 0.0; s <= curve.length_m(); s += 1e-3) {
      nearest = std::min(nearest, (curve.At(s).position - point).norm());
    }
    EXPECT_LT(nearest, 1e-3);
  }
  EXPECT_LT((curve.At(curve.length_m()).position - Bent().back()).norm(), 1e-9);
}

// Curves are parametrised by arc length: the tangent is the derivative of the position, of unit
// length, and the curvature that of the tangent. Both are continuous across pieces.
TEST(Curve, HasDerivativesByArcLength) {
  for (const Curve& curve : Curves()) {
    const double h = 1e-5;
    for (double s = 2 * h; s < curve.length_m() - 2 * h; s += 0.0371) {
      const CurvePoint before = curve.At(s - h), at = curve.At(s), behind = curve.At(s + h);
      EXPECT_NEAR(at.tangent.norm(), 1.0, 1e-12);
      EXPECT_LT(((behind.position - before.position) / (2 * h) - at.tangent).norm(), 1e-7);
      EXPECT_LT(((behind.tangent - before.tangent) / (2 * h) - at.curvature).norm(), 1e-5);
      EXPECT_LT((behind.curvature - before.curvature).norm(), 1e-2);
    }
  }
}

TEST(Curve, ApproximatesACircle) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 24;
    points.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), 1.0);
  }
  const Curve circle = Curve::Through(points, true, "");
  EXPECT_NEAR(circle.length_m(), 4.0 * std::numbers::pi, 1e-5);
  EXPECT_NEAR(circle.At(1.234).curvature.norm(), 0.5, 1e-4);
}

TEST(Curve, ClosedRepeatsAndOpenContinuesStraight) {
  const Curve closed = Curve::Through(Square(), true, "");
  EXPECT_LT((closed.At(0.3 - closed.length_m()).position - closed.At(0.3).position).norm(), 1e-9);
  EXPECT_LT((closed.At(closed.length_m() - 1e-9).position - closed.At(0).position).norm(), 1e-8);
  const Curve open = Curve::Through(Bent(), false, "");
  const CurvePoint end = open.At(open.length_m());
  const CurvePoint beyond = open.At(open.length_m() + 2.0);
  EXPECT_LT((beyond.position - end.position - 2.0 * end.tangent).norm(), 1e-9);
}

TEST(Curve, RoundedCornersKeepToTheLegs) {
  const Curve curve = Curve::Rounded(Square(), true, 1.0, "");
  EXPECT_LT(curve.length_m(), 16.0);
  EXPECT_GT(curve.length_m(), 14.0);
  for (double s = 0.0; s < curve.length_m(); s += 0.05) {
    const Vector3d p = curve.At(s).position;
    const bool on_a_leg = std::min({std::abs(p.x()), std::abs(p.x() - 4), std::abs(p.y()),
                                    std::abs(p.y() - 4)}) < 1e-9;
    const bool at_a_corner = (Vector3d(2, 2, 0) - p).cwiseAbs().head<2>().minCoeff() > 1.0 - 1e-9;
    EXPECT_TRUE(on_a_leg || at_a_corner) << p.transpose();
    EXPECT_LT(curve.At(s).curvature.norm(), 1.4);  // 1 on a circular arc
  }
}

TEST(Curve, RefusesInvalidCurves) {
  EXPECT_THAT(ErrorMessage([] {
                Curve::Through({{0, 0, 0}, {0, 0, 0}}, false, "here");
              }),
              HasSubstr("here: found points 0 and 1 at the same place"));
  EXPECT_THAT(ErrorMessage([] {
                Curve::Through({{0, 0, 0}, {1, 0, 0}}, true, "here");
              }),
              HasSubstr("at least 3"));
  EXPECT_THAT(ErrorMessage([] {
                Curve::Rounded({{0, 0, 0}, {1, 0, 0}, {0, 0.01, 0}}, false, 0.1, "here");
              }),
              HasSubstr("turn back at point 1"));
}

TEST(SpeedProfile, EasesBetweenKnots) {
  const SpeedProfile profile({{1.0, 0.5}, {2.0, 0.0}, {3.0, 0.0}, {5.0, 1.0}});
  EXPECT_DOUBLE_EQ(profile.Speed_mps(0.0), 0.5);
  EXPECT_DOUBLE_EQ(profile.Speed_mps(1.5), 0.25);
  EXPECT_DOUBLE_EQ(profile.Speed_mps(2.5), 0.0);
  EXPECT_DOUBLE_EQ(profile.Speed_mps(9.0), 1.0);
  EXPECT_DOUBLE_EQ(profile.Way_m(0.0), 0.0);
  EXPECT_DOUBLE_EQ(profile.Way_m(1.0), 0.5);
  EXPECT_DOUBLE_EQ(profile.Way_m(3.0), 0.75);
  EXPECT_DOUBLE_EQ(profile.Way_m(6.0), 2.75);
  EXPECT_DOUBLE_EQ(profile.Way_m(-1.0), -0.5);
}

TEST(SpeedProfile, SpeedIsTheDerivativeOfTheDistance) {
  const SpeedProfile profile({{0.0, 0.5}, {1.0, 0.2}, {1.5, 2.0}, {3.0, 0.0}});
  const double h = 1e-5;
  for (double t = -0.5; t < 4.0; t += 0.0173) {
    EXPECT_NEAR((profile.Way_m(t + h) - profile.Way_m(t - h)) / (2 * h), profile.Speed_mps(t),
                1e-8);
    const double before = (profile.Speed_mps(t) - profile.Speed_mps(t - h)) / h;
    const double behind = (profile.Speed_mps(t + h) - profile.Speed_mps(t)) / h;
    EXPECT_NEAR(before, behind, 1e-3);
  }
}

}  // namespace
}  // namespace cvo::synth::curve_test
