// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "core/estimation/cluster.h"

namespace cvo::cluster_state_test {
namespace {

const Eigen::Vector3d kCenter(1.0, -2.0, 0.5);
const Eigen::Matrix3d kInformation =
    (Eigen::Matrix3d() << 9.0, 1.0, 0.5, 1.0, 4.0, 0.2, 0.5, 0.2, 1.0).finished();
const RigidTransform kMotion(ExpSo3({0.4, -0.3, 0.9}), Eigen::Vector3d(3.0, 1.0, -2.0));

TEST(CenterEstimate, IsTheOriginWithoutBoxes) {
  EXPECT_EQ(CenterEstimate().InObject(), Eigen::Vector3d::Zero().eval());
  EXPECT_EQ(CenterEstimate().boxes, 0);
}

TEST(CenterEstimate, EqualsASingleBox) {
  CenterEstimate center;
  center.Add(kCenter, kInformation);
  EXPECT_EQ(center.boxes, 1);
  EXPECT_LT((center.InObject() - kCenter).norm(), 1e-12);
  EXPECT_LT((center.Covariance() - kInformation.inverse()).norm(), 1e-12);
}

// Along x, the boxes have information 1 and 3, so the mean is a quarter of the way from the second
// to the first. The covariance is that of a single box of average information.
TEST(CenterEstimate, WeightsBoxesByTheirInformation) {
  CenterEstimate center;
  center.Add(Eigen::Vector3d(4.0, 0.0, 0.0), Eigen::Vector3d(1.0, 1.0, 2.0).asDiagonal());
  center.Add(Eigen::Vector3d(0.0, 2.0, 6.0), Eigen::Vector3d(3.0, 1.0, 4.0).asDiagonal());
  EXPECT_EQ(center.boxes, 2);
  EXPECT_LT((center.InObject() - Eigen::Vector3d(1.0, 1.0, 4.0)).norm(), 1e-12);
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.5, 1.0, 1.0 / 3.0).asDiagonal();
  EXPECT_LT((center.Covariance() - expected).norm(), 1e-12);
}

TEST(CenterEstimate, MergingEqualsAddingAllBoxes) {
  CenterEstimate a;
  CenterEstimate b;
  CenterEstimate all;
  a.Add(kCenter, kInformation);
  all.Add(kCenter, kInformation);
  for (const double x : {2.0, 5.0}) {
    b.Add(Eigen::Vector3d(x, 0.0, 1.0), Eigen::Matrix3d::Identity());
    all.Add(Eigen::Vector3d(x, 0.0, 1.0), Eigen::Matrix3d::Identity());
  }
  a.Add(b);
  EXPECT_EQ(a.boxes, 3);
  EXPECT_LT((a.InObject() - all.InObject()).norm(), 1e-12);
  EXPECT_LT((a.Covariance() - all.Covariance()).norm(), 1e-12);
}

// Adding boxes in another frame and transforming the estimate to it give the same result.
TEST(CenterEstimate, TransformsWithItsFrame) {
  CenterEstimate here;
  here.Add(kCenter, kInformation);
  here.Add(Eigen::Vector3d(2.0, 0.0, 1.0), Eigen::Matrix3d::Identity());
  const CenterEstimate moved = here.In(kMotion);
  EXPECT_EQ(moved.boxes, 2);
  EXPECT_LT((moved.InObject() - kMotion * here.InObject()).norm(), 1e-12);
  const Eigen::Matrix3d R = kMotion.RotationMatrix();
  EXPECT_LT((moved.Covariance() - R * here.Covariance() * R.transpose()).norm(), 1e-12);
  CenterEstimate there;
  there.Add(kMotion, kCenter, kInformation);
  there.Add(kMotion, Eigen::Vector3d(2.0, 0.0, 1.0), Eigen::Matrix3d::Identity());
  EXPECT_LT((there.information - moved.information).norm(), 1e-12);
  EXPECT_LT((there.weighted - moved.weighted).norm(), 1e-12);
}

TEST(BodySize, IsTakenFromTheLastWholeBox) {
  BodySize size;
  size.Add(1.0, false);
  EXPECT_EQ(size.side_m, 1.0);
  size.Add(0.5, false);
  EXPECT_EQ(size.side_m, 1.0) << "the largest part";
  size.Add(2.0, false);
  EXPECT_EQ(size.side_m, 2.0);
  EXPECT_FALSE(size.is_whole);
  size.Add(1.5, true);
  EXPECT_EQ(size.side_m, 1.5);
  EXPECT_TRUE(size.is_whole);
  size.Add(3.0, false);
  EXPECT_EQ(size.side_m, 1.5) << "a part says nothing more";
  size.Add(1.2, true);
  EXPECT_EQ(size.side_m, 1.2);
  EXPECT_TRUE(size.is_whole);
}

TEST(FindState, ReturnsTheStateOfExactlyThisFrame) {
  Cluster cluster;
  for (const int frame : {3, 5, 9}) cluster.states.push_back({FrameId{frame}, 0, {}});
  for (const std::size_t i : {0u, 1u, 2u}) {
    EXPECT_EQ(FindState(cluster, cluster.states[i].frame), &cluster.states[i]);
  }
  for (const int frame : {2, 4, 6, 10}) EXPECT_EQ(FindState(cluster, FrameId{frame}), nullptr);
}

}  // namespace
}  // namespace cvo::cluster_state_test
