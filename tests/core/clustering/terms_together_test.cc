// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/clustering/affinity_term.h"
#include "core/clustering/box_term.h"
#include "core/clustering/motion_term.h"
#include "tests/core/clustering/scene.h"

namespace cvo::terms_together_test {
namespace {

using test::kSceneCamera;
using test::MakeLabel;

constexpr Eigen::Index kStaticLabel = 0;
constexpr Eigen::Index kCarLabel = 1;

CrfNode Seen(const Eigen::Vector3d& p_in_camera, const RigidTransform& past_from_now, Rng& rng) {
  const auto with_noise = [&rng](const Eigen::Vector3d& z_px) -> Eigen::Vector3d {
    return z_px + 0.4 * Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal());
  };
  const Eigen::Matrix3d covariance_px2 = 0.16 * Eigen::Matrix3d::Identity();
  CrfNode node;
  node.z_px = with_noise(*kSceneCamera.Project(p_in_camera));
  node.p_in_camera = *kSceneCamera.BackProject(node.z_px);
  node.covariance_m2 = kSceneCamera.PointCovariance(node.z_px, covariance_px2);
  node.past = CrfNode::Past{.frame = 0,
                            .z_px = with_noise(*kSceneCamera.Project(past_from_now * p_in_camera)),
                            .covariance_px2 = covariance_px2};
  return node;
}

// The first 60 nodes are on a car that drives ahead of the camera at 15 m. The next 25 are
// background points in its box, the last 15 are on the road at its wheels.
CrfScene CarScene() {
  const RigidTransform drive(ExpSo3({0.0, 0.01, 0.0}), Eigen::Vector3d(0.0, 0.0, 4.0));
  const RigidTransform follow(ExpSo3({0.0, 0.01, 0.0}), Eigen::Vector3d(0.05, 0.0, 0.3));
  Rng rng(1, "terms_together");
  CrfScene scene;
  scene.camera = kSceneCamera;
  scene.labels = {MakeLabel(LabelKind::kStatic), MakeLabel(LabelKind::kCluster),
                  MakeLabel(LabelKind::kOutlier)};
  scene.labels[kStaticLabel].past_from_now = {drive};
  scene.labels[kCarLabel].past_from_now = {follow};
  // The image of the car's nearest face, 1.8 m by 1.4 m at 14 m.
  scene.labels[kCarLabel].box = ImageBox{550, 140, 650, 225};
  scene.labels[kCarLabel].extent =
      CrfLabel::Extent{.center_in_camera = {0.0, 0.1, 15.0}, .half_size_m = {0.36, 0.28, 0.5}};
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d p(rng.Uniform(-0.9, 0.9), rng.Uniform(-0.6, 0.8), rng.Uniform(14, 16));
    scene.nodes.push_back(Seen(p, follow, rng));
  }
  for (int i = 0; i < 25; ++i) {
    const double z = rng.Uniform(22, 60);
    const Eigen::Vector3d p(rng.Uniform(-0.05, 0.05) * z, rng.Uniform(-0.04, 0.03) * z, z);
    scene.nodes.push_back(Seen(p, drive, rng));
  }
  for (int i = 0; i < 15; ++i) {
    const Eigen::Vector3d p(rng.Uniform(-0.9, 0.9), 0.8, rng.Uniform(14, 15));
    scene.nodes.push_back(Seen(p, drive, rng));
  }
  return scene;
}

struct Counts {
  int car_as_car = 0;         // of 60
  int background_as_car = 0;  // of 25
  int road_as_car = 0;        // of 15
};

template <typename Affinity, typename Motion>
Counts CountCar(const UnaryOptions& options = {.box_foot = 0.0}) {
  const CrfScene scene = CarScene();
  const EnergyMatrix total = ComputeUnaries<Box2dTerm, Affinity, Motion>(scene, options).total;
  Counts counts;
  for (Eigen::Index i = 0; i < total.rows(); ++i) {
    Eigen::Index label = 0;
    total.row(i).minCoeff(&label);
    if (label != kCarLabel) continue;
    (i < 60 ? counts.car_as_car : i < 85 ? counts.background_as_car : counts.road_as_car) += 1;
  }
  return counts;
}

// As section 3.2 of the paper claims, the 3D term prunes the background and the motion term the
// road.
TEST(UnaryTerms, EachAddsInformationThatTheOthersLack) {
  const Counts box = CountCar<NoAffinityTerm, NoMotionTerm>();
  const Counts space = CountCar<AffinityTerm, NoMotionTerm>();
  const Counts all = CountCar<AffinityTerm, MotionTerm>();
  EXPECT_GE(box.background_as_car, 20);
  EXPECT_GE(box.road_as_car, 12);
  EXPECT_LE(space.background_as_car, 5);
  EXPECT_GE(space.road_as_car, 10);
  EXPECT_LE(all.background_as_car, 2);
  EXPECT_LE(all.road_as_car, 1);
  EXPECT_GE(all.car_as_car, 55);
}

// The foot of the box also prunes the road, for bodies observed too briefly to show their motion.
TEST(UnaryTerms, BoxFootPrunesTheRoadWithoutMotion) {
  const Counts counts = CountCar<AffinityTerm, NoMotionTerm>(UnaryOptions{});
  EXPECT_LE(counts.road_as_car, 5);
  EXPECT_GE(counts.car_as_car, 50);
}

// METHOD.md 5.4: the printed 3D term does not add the spread of the body to the noise, and so loses
// the body.
TEST(UnaryTerms, PrintedAffinityTermLosesTheBody) {
  EXPECT_GE((CountCar<AffinityTerm, NoMotionTerm>().car_as_car), 55);
  EXPECT_LE((CountCar<AffinityTermLiteral, NoMotionTerm>().car_as_car), 30);
}

}  // namespace
}  // namespace cvo::terms_together_test
