// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/schur_solver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace cvo {

SchurEquations::SchurEquations(const std::vector<int>& pose_of_frame, int others,
                               std::size_t point_count,
                               const std::vector<ReprojectionFactor>& factors)
    : points(point_count), couplings_begin(point_count + 1, 0) {
  const int poses =
      pose_of_frame.empty() ? 0 : 1 + *std::max_element(pose_of_frame.begin(), pose_of_frame.end());
  pose_H.resize(poses);
  H.resize(6 * poses + others, 6 * poses + others);
  g.resize(6 * poses + others);
  int last_point = 0;
  int last_pose = -1;
  int count = 0;
  for (const ReprojectionFactor& factor : factors) {
    Require(factor.point >= last_point && factor.point < static_cast<int>(point_count) &&
                factor.pose >= 0 && factor.pose < static_cast<int>(pose_of_frame.size()) &&
                (factor.point > last_point || factor.pose > last_pose),
            "solver: factors must be by point, then by ascending pose, of points and poses that "
            "are there");
    last_point = factor.point;
    last_pose = factor.pose;
    if (pose_of_frame[factor.pose] >= 0) couplings_begin[factor.point + 1] = ++count;
  }
  // A point without couplings has an empty range.
  for (std::size_t p = 1; p <= point_count; ++p) {
    couplings_begin[p] = std::max(couplings_begin[p], couplings_begin[p - 1]);
  }
  couplings.resize(count);
}

void SchurEquations::SetZero() {
  for (Matrix6d& block : pose_H) block.setZero();
  H.setZero();
  g.setZero();
  points.assign(points.size(), PointEquations());
}

double SchurEquations::LargestGradient() const {
  double largest = g.size() > 0 ? g.cwiseAbs().maxCoeff() : 0.0;
  for (const PointEquations& point : points) {
    largest = std::max(largest, point.g.cwiseAbs().maxCoeff());
  }
  return largest;
}

namespace {

// Lower bound of the diagonal that is damped: an unconstrained variable keeps its value, and its
// row of H + D must not be zero.
constexpr double kSmallestDiagonal = 1e-6;

Eigen::Vector3d PointDamping(const Eigen::Matrix3d& H, double radius) {
  return H.diagonal().cwiseMax(kSmallestDiagonal) / radius;
}

// Computes L^-1 of the symmetric A = L L^T; returns false if A is not positive definite.
bool InvertRoot(const Eigen::Matrix3d& A, Eigen::Matrix3d& inverse) {
  const double d0 = A(0, 0);
  if (!(d0 > 0.0)) return false;
  const double i0 = 1.0 / std::sqrt(d0);
  const double l10 = A(1, 0) * i0;
  const double l20 = A(2, 0) * i0;
  const double d1 = A(1, 1) - l10 * l10;
  if (!(d1 > 0.0)) return false;
  const double i1 = 1.0 / std::sqrt(d1);
  const double l21 = (A(2, 1) - l20 * l10) * i1;
  const double d2 = A(2, 2) - l20 * l20 - l21 * l21;
  if (!(d2 > 0.0)) return false;
  const double i2 = 1.0 / std::sqrt(d2);
  inverse << i0, 0.0, 0.0,      //
      -l10 * i0 * i1, i1, 0.0,  //
      (l10 * l21 * i1 - l20) * i0 * i2, -l21 * i1 * i2, i2;
  return true;
}

// sum += a b^T, column by column; Eigen's product would load each element of b three times.
void AddProduct(const Matrix63d& a, const Matrix63d& b, Matrix6d& sum) {
  for (int j = 0; j < 6; ++j) {
    sum.col(j) += a.col(0) * b(j, 0) + a.col(1) * b(j, 1) + a.col(2) * b(j, 2);
  }
}

std::size_t PairIndex(int row, int column) {
  return static_cast<std::size_t>(row) * (row + 1) / 2 + column;
}

}  // namespace

SchurSolver::SchurSolver(const SchurEquations& equations) {
  const int poses = static_cast<int>(equations.pose_H.size());
  pairs_.resize(PairIndex(poses, 0));
  point_root_.resize(equations.points.size());
  E_.resize(poses);
  const Eigen::Index size = equations.g.size();
  damping_.resize(size);
  rhs_.resize(size);
  shared_columns_.resize(size, SchurEquations::kShared);
  S_.resize(size, size);
}

bool SchurSolver::Solve(const SchurEquations& equations, double radius, SchurStep& step) {
  for (Matrix6d& pair : pairs_) pair.setZero();
  shared_columns_.setZero();
  rhs_ = -equations.g;
  for (std::size_t p = 0; p < equations.points.size(); ++p) {
    if (!Eliminate(equations, p, radius)) return false;
  }
  AssembleReduced(equations, radius);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(S_);  // in place
  if (factor.info() != Eigen::Success) return false;
  step.reduced = factor.solve(rhs_);
  SubstitutePoints(equations, radius, step);
  return std::isfinite(step.norm);
}

bool SchurSolver::Eliminate(const SchurEquations& equations, std::size_t point, double radius) {
  const PointEquations& own = equations.points[point];
  Eigen::Matrix3d damped = own.H;
  damped.diagonal() += PointDamping(own.H, radius);
  Eigen::Matrix3d& root = point_root_[point];
  if (!InvertRoot(damped, root)) return false;
  const Eigen::Vector3d g = root * own.g;
  const int begin = equations.couplings_begin[point];
  const int end = equations.couplings_begin[point + 1];
  for (int i = begin; i < end; ++i) {
    const PoseCoupling& coupling = equations.couplings[i];
    Matrix63d& E = E_[i - begin];
    E = LeverTransposeTimes(coupling.lever, coupling.M * root.transpose());
    rhs_.segment<6>(6 * coupling.pose).noalias() += E * g;
  }
  AddPairs(equations, begin, end);
  if (equations.points_see_shared) AddSharedColumns(equations, point);
  return true;
}

void SchurSolver::AddPairs(const SchurEquations& equations, int begin, int end) {
  for (int i = begin; i < end; ++i) {
    const Matrix63d& row = E_[i - begin];
    Matrix6d* pairs = &pairs_[PairIndex(equations.couplings[i].pose, 0)];
    for (int k = begin; k <= i; ++k) {
      AddProduct(row, E_[k - begin], pairs[equations.couplings[k].pose]);
    }
  }
}

void SchurSolver::AddSharedColumns(const SchurEquations& equations, std::size_t point) {
  const PointEquations& own = equations.points[point];
  const Matrix36d e = point_root_[point] * own.by_shared;
  const int begin = equations.couplings_begin[point];
  for (int i = begin; i < equations.couplings_begin[point + 1]; ++i) {
    shared_columns_.middleRows<6>(6 * equations.couplings[i].pose).noalias() +=
        E_[i - begin].lazyProduct(e);
  }
  const int shared = equations.others_begin();
  shared_columns_.middleRows<6>(shared).noalias() += e.transpose().lazyProduct(e);
  rhs_.segment<6>(shared) += e.transpose() * (point_root_[point] * own.g);
}

void SchurSolver::AssembleReduced(const SchurEquations& equations, double radius) {
  S_.triangularView<Eigen::Lower>() = equations.H;
  const int poses = static_cast<int>(equations.pose_H.size());
  for (int i = 0; i < poses; ++i) S_.block<6, 6>(6 * i, 6 * i) += equations.pose_H[i];
  damping_ = S_.diagonal().cwiseMax(kSmallestDiagonal) / radius;
  S_.diagonal() += damping_;
  for (int i = 0; i < poses; ++i) {
    for (int k = 0; k <= i; ++k) S_.block<6, 6>(6 * i, 6 * k) -= pairs_[PairIndex(i, k)];
  }
  if (equations.points_see_shared) {
    const int shared = equations.others_begin();
    S_.middleRows<6>(shared).leftCols(shared + 6) -=
        shared_columns_.topRows(shared + 6).transpose();
  }
}

void SchurSolver::SubstitutePoints(const SchurEquations& equations, double radius,
                                   SchurStep& step) const {
  const Eigen::VectorXd& dx = step.reduced;
  Vector6d shared = Vector6d::Zero();
  if (equations.points_see_shared) shared = dx.segment<6>(equations.others_begin());
  double slope = equations.g.dot(dx);
  double damped = damping_.dot(dx.cwiseAbs2());
  double squared_norm = dx.squaredNorm();
  step.points.resize(equations.points.size());
  for (std::size_t p = 0; p < equations.points.size(); ++p) {
    const PointEquations& own = equations.points[p];
    Eigen::Vector3d g = own.g + own.by_shared * shared;
    for (int i = equations.couplings_begin[p]; i < equations.couplings_begin[p + 1]; ++i) {
      const PoseCoupling& coupling = equations.couplings[i];
      const Eigen::Vector3d rotation = dx.segment<3>(6 * coupling.pose);
      const Eigen::Vector3d translation = dx.segment<3>(6 * coupling.pose + 3);
      g.noalias() += coupling.M.transpose() * (coupling.lever.cross(rotation) - translation);
    }
    const Eigen::Vector3d move = -(point_root_[p].transpose() * (point_root_[p] * g));
    slope += own.g.dot(move);
    damped += PointDamping(own.H, radius).dot(move.cwiseAbs2());
    squared_norm += move.squaredNorm();
    step.points[p] = move;
  }
  // dx^T H dx = -g^T dx - dx^T D dx at the solution.
  step.expected_decrease = 0.5 * (damped - slope);
  step.norm = std::sqrt(squared_norm);
}

Matrix6d SchurSolver::SharedInformation() const {
  const Matrix6d L = S_.bottomRightCorner<6, 6>().triangularView<Eigen::Lower>();
  return L * L.transpose();
}

}  // namespace cvo
