// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/gradient_check.h"

#include <cmath>
#include <string>

namespace cvo::test {
namespace {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::MatrixXd CentralDifferences(const VectorFunction& f, const Eigen::VectorXd& x, double step) {
  Eigen::MatrixXd J;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd plus = x;
    Eigen::VectorXd minus = x;
    plus[i] += step;
    minus[i] -= step;
    const Eigen::VectorXd column = (f(plus) - f(minus)) / (plus[i] - minus[i]);
    if (i == 0) J.resize(column.size(), x.size());
    J.col(i) = column;
  }
  return J;
}

testing::AssertionResult Near(const Eigen::MatrixXd& analytic, const Eigen::MatrixXd& numeric,
                              double tolerance) {
  if (analytic.rows() != numeric.rows() || analytic.cols() != numeric.cols()) {
    return testing::AssertionFailure()
           << "analytic Jacobian is " << analytic.rows() << "x" << analytic.cols()
           << ", numeric one " << numeric.rows() << "x" << numeric.cols();
  }
  const Eigen::ArrayXXd error = (analytic - numeric).array().abs() / (1.0 + numeric.array().abs());
  Eigen::Index row = 0;
  Eigen::Index col = 0;
  const bool finite = error.isFinite().all();
  if (finite && error.maxCoeff(&row, &col) <= tolerance) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "entry (" << row << ", " << col << ") is off by " << error(row, col) << "\nanalytic\n"
         << analytic << "\nnumeric\n"
         << numeric;
}

// Evaluates the cost at `blocks`. Fills all non-empty `jacobians`, in ambient coordinates; null if
// none are requested.
bool Evaluate(const ceres::CostFunction& cost, const std::vector<Eigen::VectorXd>& blocks,
              Eigen::VectorXd* residuals, std::vector<RowMajorMatrix>* jacobians) {
  std::vector<const double*> values;
  for (const Eigen::VectorXd& block : blocks) values.push_back(block.data());
  residuals->setConstant(cost.num_residuals(), std::nan(""));
  if (jacobians == nullptr) return cost.Evaluate(values.data(), residuals->data(), nullptr);
  std::vector<double*> pointers;
  for (RowMajorMatrix& jacobian : *jacobians) {
    pointers.push_back(jacobian.size() > 0 ? jacobian.data() : nullptr);
  }
  return cost.Evaluate(values.data(), residuals->data(), pointers.data());
}

Eigen::VectorXd Plus(const ParameterBlock& block, const Eigen::VectorXd& tangent) {
  if (block.manifold == nullptr) return block.value + tangent;
  Eigen::VectorXd moved(block.value.size());
  block.manifold->Plus(block.value.data(), tangent.data(), moved.data());
  return moved;
}

RowMajorMatrix PlusJacobian(const ParameterBlock& block) {
  const Eigen::Index size = block.value.size();
  if (block.manifold == nullptr) return RowMajorMatrix::Identity(size, size);
  RowMajorMatrix J(size, block.manifold->TangentSize());
  block.manifold->PlusJacobian(block.value.data(), J.data());
  return J;
}

testing::AssertionResult CheckBlock(const ceres::CostFunction& cost,
                                    const std::vector<ParameterBlock>& blocks, std::size_t index,
                                    double tolerance) {
  std::vector<Eigen::VectorXd> values;
  for (const ParameterBlock& block : blocks) values.push_back(block.value);
  Eigen::VectorXd plain;
  Eigen::VectorXd residuals;
  std::vector<RowMajorMatrix> jacobians(blocks.size());
  jacobians[index].setConstant(cost.num_residuals(), blocks[index].value.size(), std::nan(""));
  if (!Evaluate(cost, values, &plain, nullptr) || !Evaluate(cost, values, &residuals, &jacobians)) {
    return testing::AssertionFailure() << "Evaluate returned false";
  }
  if (plain != residuals) {
    return testing::AssertionFailure() << "residuals change when a Jacobian is asked for";
  }
  const auto along_tangent = [&](const Eigen::VectorXd& tangent) {
    std::vector<Eigen::VectorXd> moved = values;
    moved[index] = Plus(blocks[index], tangent);
    Eigen::VectorXd result;
    Evaluate(cost, moved, &result, nullptr);
    return result;
  };
  const RowMajorMatrix plus_jacobian = PlusJacobian(blocks[index]);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(plus_jacobian.cols());
  return Near(jacobians[index] * plus_jacobian, NumericJacobian(along_tangent, zero), tolerance);
}

}  // namespace

Eigen::MatrixXd NumericJacobian(const VectorFunction& f, const Eigen::VectorXd& x, double step) {
  return (4.0 * CentralDifferences(f, x, 0.5 * step) - CentralDifferences(f, x, step)) / 3.0;
}

testing::AssertionResult JacobianMatches(const VectorFunction& f, const Eigen::VectorXd& x,
                                         const Eigen::MatrixXd& analytic, double tolerance) {
  return Near(analytic, NumericJacobian(f, x), tolerance);
}

testing::AssertionResult CostJacobiansMatch(const ceres::CostFunction& cost,
                                            const std::vector<ParameterBlock>& blocks,
                                            double tolerance) {
  if (cost.parameter_block_sizes().size() != blocks.size()) {
    return testing::AssertionFailure() << "the cost has " << cost.parameter_block_sizes().size()
                                       << " parameter blocks, given are " << blocks.size();
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (cost.parameter_block_sizes()[i] != blocks[i].value.size()) {
      return testing::AssertionFailure() << "parameter block " << i << " has the wrong size";
    }
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const testing::AssertionResult result = CheckBlock(cost, blocks, i, tolerance);
    if (!result) {
      return testing::AssertionFailure() << "parameter block " << i << ": " << result.message();
    }
  }
  return testing::AssertionSuccess();
}

}  // namespace cvo::test
