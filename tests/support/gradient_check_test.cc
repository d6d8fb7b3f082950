// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/gradient_check.h"

#include <ceres/sized_cost_function.h>

#include <algorithm>
#include <cmath>

namespace cvo::test {
namespace {

Eigen::VectorXd Cubes(const Eigen::VectorXd& x) { return x.array().cube().matrix(); }

TEST(GradientCheck, AcceptsTheDerivative) {
  const Eigen::Vector2d x(2.0, -3.0);
  EXPECT_TRUE(JacobianMatches(Cubes, x, Eigen::Vector2d(12.0, 27.0).asDiagonal(), 1e-9));
}

TEST(GradientCheck, RejectsWrongEntriesShapesAndNaN) {
  const Eigen::Vector2d x(2.0, -3.0);
  EXPECT_FALSE(JacobianMatches(Cubes, x, Eigen::Vector2d(12.0, 27.001).asDiagonal()));
  EXPECT_FALSE(JacobianMatches(Cubes, x, Eigen::MatrixXd::Zero(2, 3)));
  EXPECT_FALSE(JacobianMatches(Cubes, x, Eigen::Vector2d(12.0, std::nan("")).asDiagonal()));
}

// Rotates (1, 0, 0) by a quaternion (x, y, z, w) and scales the result. A nonzero error_ falsifies
// the Jacobian with respect to the quaternion.
class ScaledAxis : public ceres::SizedCostFunction<3, 4, 1> {
 public:
  explicit ScaledAxis(double error) : error_(error) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::Vector4d> q(parameters[0]);
    const double scale = parameters[1][0];
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const Eigen::Vector3d axis(x * x + w * w - y * y - z * z, 2 * (x * y + w * z),
                               2 * (x * z - w * y));
    Eigen::Map<Eigen::Vector3d> r(residuals);
    r = scale * axis;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> J(jacobians[0]);
      J << x, -y, -z, w, y, x, w, z, z, -w, x, -y;
      J *= 2.0 * scale + error_;
    }
    if (jacobians[1] != nullptr) std::copy_n(axis.data(), 3, jacobians[1]);
    return true;
  }

 private:
  double error_;
};

TEST(GradientCheck, ChecksACostOnItsManifold) {
  const ceres::EigenQuaternionManifold manifold;
  const std::vector<ParameterBlock> blocks = {{Eigen::Vector4d(0.1, -0.5, 0.7, 0.5), &manifold},
                                              {Eigen::VectorXd::Constant(1, 3.0), nullptr}};
  EXPECT_TRUE(CostJacobiansMatch(ScaledAxis(0.0), blocks));
  EXPECT_FALSE(CostJacobiansMatch(ScaledAxis(0.01), blocks));
}

TEST(GradientCheck, RejectsBlocksThatDoNotFitTheCost) {
  const ParameterBlock quaternion{Eigen::Vector4d(0, 0, 0, 1), nullptr};
  EXPECT_FALSE(CostJacobiansMatch(ScaledAxis(0.0), {quaternion}));
  EXPECT_FALSE(CostJacobiansMatch(ScaledAxis(0.0), {quaternion, quaternion}));
}

}  // namespace
}  // namespace cvo::test
