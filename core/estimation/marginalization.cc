// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/marginalization.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/solvers/reprojection_cost.h"

namespace cvo {
namespace {

constexpr double kRelativeRank = 1e-10;

// H dx = -b, linearised at the problem's state: six rows per frame, then six for right_field_px.
struct LinearSystem {
  Eigen::MatrixXd H;
  Eigen::VectorXd b;

  Eigen::Index field() const { return b.size() / 6 - 1; }
};

void AppendRows(Eigen::Index block, std::vector<Eigen::Index>& rows) {
  for (Eigen::Index k = 0; k < 6; ++k) rows.push_back(6 * block + k);
}

// Pseudo-inverse M^+ of a symmetric positive semi-definite matrix.
Eigen::MatrixXd PseudoInverse(const Eigen::MatrixXd& M) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(M);
  const Eigen::VectorXd& values = eigen.eigenvalues();
  const double smallest = kRelativeRank * values[values.size() - 1];
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (values[i] > smallest) inverse[i] = 1.0 / values[i];
  }
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

// Adds the factors [begin, end), all of one point, with the point eliminated.
void AddPoint(const NoiseOptions& noise, const WindowProblem& problem, std::size_t begin,
              std::size_t end, LinearSystem& system) {
  const int n = static_cast<int>(end - begin);
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3 * n, 6 * n + 6);
  Eigen::MatrixXd J_point(3 * n, 3);
  Eigen::VectorXd r(3 * n);
  std::vector<Eigen::Index> rows;  // row of the system for each column of J
  for (int i = 0; i < n; ++i) {
    const ReprojectionFactor& factor = problem.factors[begin + i];
    const ReprojectionResidual value =
        EvaluateReprojection(problem.camera, factor.z_px, factor.sqrt_information,
                             problem.world_from_camera[factor.pose], problem.points[factor.point]);
    const double root = std::sqrt(HuberWeight(value.r.squaredNorm(), noise.huber));
    J.block<3, 6>(3 * i, 6 * i) = root * value.J_pose;
    J.block<3, 6>(3 * i, 6 * n) = root * value.J_field;
    J_point.middleRows<3>(3 * i) = root * value.J_point;
    r.segment<3>(3 * i) = root * value.r;
    AppendRows(factor.pose, rows);
  }
  AppendRows(system.field(), rows);
  const Eigen::MatrixXd coupling = J.transpose() * J_point;
  const Eigen::MatrixXd left = coupling * PseudoInverse(J_point.transpose() * J_point);
  system.H(rows, rows) += J.transpose() * J - left * coupling.transpose();
  system.b(rows) += J.transpose() * r - left * (J_point.transpose() * r);
}

// Adds the prior, relinearised at the problem's state.
void AddPrior(const WindowProblem& problem, LinearSystem& system) {
  const WindowPrior& prior = problem.prior;
  const int n = static_cast<int>(prior.frames.size());
  std::vector<Eigen::Index> rows;
  Eigen::VectorXd dx(6 * n + 6);
  Eigen::MatrixXd J = prior.J0;
  for (int i = 0; i < n; ++i) {
    const Eigen::Index pose = FrameIndex(problem, prior.frames[i]);
    dx.segment<6>(6 * i) = problem.world_from_camera[pose].Minus(prior.linearization_point[i]);
    J.middleCols<3>(6 * i) =
        prior.J0.middleCols<3>(6 * i) * InverseRightJacobianSo3(dx.segment<3>(6 * i));
    AppendRows(pose, rows);
  }
  dx.tail<6>() = problem.camera.right_field_px - prior.right_field_point_px;
  AppendRows(system.field(), rows);
  const Eigen::VectorXd r = prior.r0 + prior.J0 * dx;
  system.H(rows, rows) += J.transpose() * J;
  system.b(rows) += J.transpose() * r;
}

// Indices of the frames that the system constrains, except the removed one.
std::vector<int> KeptPoses(const WindowProblem& problem, FrameId removed,
                           const LinearSystem& system) {
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(problem.frames.size()); ++i) {
    if (problem.frames[i] == removed) continue;
    if (!system.H.block<6, 6>(6 * i, 6 * i).isZero(0.0)) kept.push_back(i);
  }
  return kept;
}

// Reduces the system to the poses `kept` and right_field_px by eliminating the pose `removed`.
LinearSystem Reduce(const LinearSystem& system, const std::vector<int>& kept, int removed) {
  std::vector<Eigen::Index> rows;
  for (const int pose : kept) AppendRows(pose, rows);
  AppendRows(system.field(), rows);
  const auto six = Eigen::seqN(6 * removed, 6);
  const Eigen::MatrixXd coupling = system.H(rows, six);
  const Eigen::MatrixXd left = coupling * PseudoInverse(system.H(six, six));
  return {system.H(rows, rows) - left * coupling.transpose(),
          system.b(rows) - left * system.b(six)};
}

// Sets J0 and r0 such that H = J0^T J0 and b = J0^T r0. H is singular, so its square root is formed
// from its eigenvectors.
void TakeSquareRoot(const LinearSystem& system, WindowPrior& prior) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 *
                                                             (system.H + system.H.transpose()));
  const Eigen::VectorXd& values = eigen.eigenvalues();  // ascending
  const double smallest = kRelativeRank * values[values.size() - 1];
  const Eigen::Index rank = (values.array() > smallest).count();
  const Eigen::VectorXd roots = values.tail(rank).cwiseSqrt();
  const Eigen::MatrixXd V_transposed = eigen.eigenvectors().rightCols(rank).transpose();
  prior.J0 = roots.asDiagonal() * V_transposed;
  prior.r0 = roots.cwiseInverse().asDiagonal() * V_transposed * system.b;
}

}  // namespace

WindowPrior Marginalize(const NoiseOptions& noise, const WindowProblem& problem, FrameId removed) {
  const int size = 6 * static_cast<int>(problem.frames.size()) + 6;
  LinearSystem system{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  for (std::size_t begin = 0; begin < problem.factors.size();) {
    std::size_t end = begin;
    while (end < problem.factors.size() &&
           problem.factors[end].point == problem.factors[begin].point) {
      ++end;
    }
    AddPoint(noise, problem, begin, end, system);
    begin = end;
  }
  AddPrior(problem, system);

  const std::vector<int> kept = KeptPoses(problem, removed, system);
  WindowPrior prior;
  TakeSquareRoot(Reduce(system, kept, FrameIndex(problem, removed)), prior);
  prior.right_field_point_px = problem.camera.right_field_px;
  for (const int i : kept) {
    prior.frames.push_back(problem.frames[i]);
    prior.linearization_point.push_back(problem.world_from_camera[i]);
  }
  return prior;
}

}  // namespace cvo
