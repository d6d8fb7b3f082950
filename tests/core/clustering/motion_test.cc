// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "core/base/rng.h"
#include "core/clustering/unary_terms.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::motion_test {
namespace {

using test::kSceneCamera;
using test::MakeLabel;
using test::NodeAt;

constexpr Eigen::Index kStaticLabel = 0;
constexpr Eigen::Index kBodyLabel = 1;
constexpr Eigen::Index kNewBoxLabel = 2;

RigidTransform Shift(double x, double y, double z) {
  return RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, y, z));
}

// A scene with one past frame, in which the static scene and a body have the given transforms.
CrfScene MotionScene(const RigidTransform& static_past_from_now,
                     const RigidTransform& body_past_from_now) {
  CrfScene scene;
  scene.camera = kSceneCamera;
  scene.labels = {MakeLabel(LabelKind::kStatic), MakeLabel(LabelKind::kCluster),
                  MakeLabel(LabelKind::kNewBox), MakeLabel(LabelKind::kOutlier)};
  scene.labels[kStaticLabel].past_from_now = {static_past_from_now};
  scene.labels[kBodyLabel].past_from_now = {body_past_from_now};
  return scene;
}

// Errors common to u_left and u_right, plus an independent error of the disparity.
Eigen::Matrix3d PixelCovariance() {
  Eigen::Matrix3d covariance;
  covariance << 0.25, 0.0, 0.25, 0.0, 0.25, 0.0, 0.25, 0.0, 0.25 + 0.09;
  return covariance;
}

Eigen::Vector3d WithNoise(const Eigen::Vector3d& z_px, const Eigen::Matrix3d& covariance_px2,
                          Rng& rng) {
  const Eigen::Vector3d unit(rng.Normal(), rng.Normal(), rng.Normal());
  return z_px + covariance_px2.llt().matrixL() * unit;
}

// Measures a point with noise, now and in the past, when it was at past_from_now * p_in_camera.
CrfNode Measure(const Eigen::Vector3d& p_in_camera, const RigidTransform& past_from_now,
                const Eigen::Matrix3d& covariance_px2, Rng& rng) {
  CrfNode node;
  node.z_px = WithNoise(*kSceneCamera.Project(p_in_camera), covariance_px2, rng);
  node.p_in_camera = *kSceneCamera.BackProject(node.z_px);
  node.covariance_m2 = kSceneCamera.PointCovariance(node.z_px, covariance_px2);
  node.past = CrfNode::Past{
      .z_px = WithNoise(*kSceneCamera.Project(past_from_now * p_in_camera), covariance_px2, rng),
      .covariance_px2 = covariance_px2};
  return node;
}

template <typename Term>
EnergyMatrix RawEnergies(const CrfScene& scene, const UnaryOptions& options = {}) {
  EnergyMatrix energies(static_cast<Eigen::Index>(scene.nodes.size()),
                        static_cast<Eigen::Index>(scene.labels.size()));
  Term::Energies(scene, options, energies);
  return energies;
}

CrfNode NodeWithPast(const Eigen::Vector3d& p_in_camera, const Eigen::Vector3d& p_in_past) {
  CrfNode node = NodeAt(p_in_camera);
  node.past =
      CrfNode::Past{.z_px = *kSceneCamera.Project(p_in_past), .covariance_px2 = PixelCovariance()};
  return node;
}

TEST(MotionTerm, MatchesHandComputedValue) {
  // The camera rolled by a right angle: what is now at (1, 0, 10) was at (0, 1, 10) in the past.
  Eigen::Matrix3d turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  CrfScene scene = MotionScene(RigidTransform(turn, Eigen::Vector3d::Zero()), Shift(5, 0, 0));
  CrfNode node = NodeWithPast({1, 0, 10}, {0, 1, 10});
  node.past->z_px += Eigen::Vector3d(0.0, 7.0, 0.0);
  node.past->covariance_px2 = Eigen::Matrix3d::Identity();
  // The variance of 0.01 m^2 along x maps to v in the past frame: J = 70 px/m, S = 1 + 49 px^2.
  node.covariance_m2 = Eigen::Vector3d(0.01, 1e-12, 1e-12).asDiagonal();
  scene.nodes = {node};
  EXPECT_NEAR(RawEnergies<MotionTerm>(scene)(0, kStaticLabel), 0.5 * 49.0 / 50.0, 1e-6);
}

TEST(MotionTerm, PrefersTheEstimatedToTheTriangulatedPosition) {
  CrfScene scene = MotionScene(Shift(0, 0, 0), Shift(5, 0, 0));
  CrfNode node = NodeWithPast({1, 0, 10}, {1, 0, 10});
  node.p_in_camera = {1, 0, 12};  // due to a bad disparity
  node.past->covariance_px2 = Eigen::Matrix3d::Identity();
  scene.nodes = {node};
  EXPECT_GT(RawEnergies<MotionTerm>(scene)(0, kStaticLabel), 1.0);
  scene.nodes[0].estimate = CrfNode::Place{Eigen::Vector3d(1, 0, 10)};
  EXPECT_NEAR(RawEnergies<MotionTerm>(scene)(0, kStaticLabel), 0.0, 1e-9);
}

TEST(MotionTerm, TheTrueLabelCostsOneAndAHalfNatsOnAverage) {
  const RigidTransform body(ExpSo3({0.02, -0.1, 0.03}), Eigen::Vector3d(-0.6, 0.05, 0.8));
  CrfScene scene = MotionScene(Shift(0.1, 0, 1.0), body);
  Rng rng(1, "motion");
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector3d p(rng.Uniform(-3, 3), rng.Uniform(-1, 1), rng.Uniform(5, 12));
    scene.nodes.push_back(Measure(p, body, PixelCovariance(), rng));
  }
  const EnergyMatrix energies = RawEnergies<MotionTerm>(scene, UnaryOptions{.motion_cap = 1e6});
  EXPECT_NEAR(energies.col(kBodyLabel).mean(), 1.5, 0.06);  // 3 standard errors
  EXPECT_GT(energies.col(kStaticLabel).mean(), 20.0);
}

TEST(MotionTerm, AMovingPointFavoursItsLabelByTheChiSquareOfItsMotion) {
  // The camera stands still and the body moved 5 cm sideways at 10 m. This shifts u_left and
  // u_right by 3.5 px, with a variance of 1 px^2 at both times, and costs 1/2 (2 * 3.5^2) / 2 nats.
  CrfScene scene = MotionScene(RigidTransform(), Shift(-0.05, 0, 0));
  Rng rng(2, "motion");
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector3d p(rng.Uniform(-3, 3), rng.Uniform(-1, 1), 10.0);
    scene.nodes.push_back(Measure(p, Shift(-0.05, 0, 0), Eigen::Matrix3d::Identity(), rng));
  }
  const EnergyMatrix energies = RawEnergies<MotionTerm>(scene, UnaryOptions{.motion_cap = 1e6});
  EXPECT_NEAR((energies.col(kStaticLabel) - energies.col(kBodyLabel)).mean(), 6.125, 0.2);
}

TEST(MotionTerm, DoesNotTakeDistantStaticPointsForMoving) {
  // After five frames of driving; at 150 m the disparity is 2.3 px with an error of 0.3 px.
  const RigidTransform drive = Shift(0.0, 0.0, 6.0);
  CrfScene scene = MotionScene(drive, Shift(0, 0, 1.0));
  Rng rng(3, "motion");
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d p(rng.Uniform(-60, 60), rng.Uniform(-20, 5), 150.0);
    scene.nodes.push_back(Measure(p, drive, PixelCovariance(), rng));
  }
  const EnergyMatrix energies = RawEnergies<MotionTerm>(scene);
  EXPECT_LT(energies.col(kStaticLabel).mean(), 2.0);
  const auto outliers = (energies.col(kStaticLabel).array() > 4.5).count();
  EXPECT_LT(outliers, 50);
}

TEST(MotionTerm, IsZeroForLandmarksWithoutAPast) {
  CrfScene scene = MotionScene(RigidTransform(), Shift(1, 0, 0));
  scene.nodes = {NodeAt({0, 0, 10})};
  EXPECT_TRUE(RawEnergies<MotionTerm>(scene).isZero(0.0));
}

TEST(MotionTerm, IsNeutralForLabelsOfUnknownMotion) {
  CrfScene scene = MotionScene(RigidTransform(), Shift(1, 0, 0));
  scene.labels[kBodyLabel].past_from_now = std::nullopt;
  scene.labels[kNewBoxLabel].past_from_now = {RigidTransform()};
  scene.nodes = {NodeWithPast({0, 0, 10}, {0, 0, 10})};
  EXPECT_EQ(Eigen::RowVectorXd(RawEnergies<MotionTerm>(scene).row(0)),
            Eigen::RowVector4d(0.0, 1.5, 1.5, 4.5));
}

constexpr Eigen::Index kCarLabel = 1;

// The first 60 nodes are on a car that drives ahead of the camera at 15 m. The next 25 are
// background points in its box, the last 15 are on the road at its wheels.
CrfScene CarScene() {
  const RigidTransform drive(ExpSo3({0.0, 0.01, 0.0}), Eigen::Vector3d(0.0, 0.0, 4.0));
  const RigidTransform follow(ExpSo3({0.0, 0.01, 0.0}), Eigen::Vector3d(0.05, 0.0, 0.3));
  const Eigen::Matrix3d covariance_px2 = 0.16 * Eigen::Matrix3d::Identity();
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
    scene.nodes.push_back(Measure(p, follow, covariance_px2, rng));
  }
  for (int i = 0; i < 25; ++i) {
    const double z = rng.Uniform(22, 60);
    const Eigen::Vector3d p(rng.Uniform(-0.05, 0.05) * z, rng.Uniform(-0.04, 0.03) * z, z);
    scene.nodes.push_back(Measure(p, drive, covariance_px2, rng));
  }
  for (int i = 0; i < 15; ++i) {
    const Eigen::Vector3d p(rng.Uniform(-0.9, 0.9), 0.8, rng.Uniform(14, 15));
    scene.nodes.push_back(Measure(p, drive, covariance_px2, rng));
  }
  return scene;
}

struct Counts {
  int car_as_car = 0;         // of 60
  int background_as_car = 0;  // of 25
  int road_as_car = 0;        // of 15
};

template <typename Affinity, typename Motion>
Counts CountCar() {
  const CrfScene scene = CarScene();
  const EnergyMatrix total = ComputeUnaries<Box2dTerm, Affinity, Motion>(scene, {});
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
  const Counts box = CountCar<NoTerm, NoTerm>();
  const Counts space = CountCar<AffinityTerm, NoTerm>();
  const Counts all = CountCar<AffinityTerm, MotionTerm>();
  EXPECT_GE(box.background_as_car, 20);
  EXPECT_GE(box.road_as_car, 12);
  EXPECT_LE(space.background_as_car, 5);
  EXPECT_GE(space.road_as_car, 10);
  EXPECT_LE(all.background_as_car, 2);
  EXPECT_LE(all.road_as_car, 1);
  EXPECT_GE(all.car_as_car, 55);
}

// METHOD.md 5.4: the printed 3D term does not add the spread of the body to the noise, and so loses
// the body.
TEST(UnaryTerms, PrintedAffinityTermLosesTheBody) {
  EXPECT_GE((CountCar<AffinityTerm, NoTerm>().car_as_car), 55);
  EXPECT_LE((CountCar<AffinityTermLiteral, NoTerm>().car_as_car), 30);
}

}  // namespace
}  // namespace cvo::motion_test
