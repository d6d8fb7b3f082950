// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/marginalization.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/estimation/reprojection_cost.h"

namespace cvo {
namespace {

constexpr double kRelativeRank = 1e-10;

// H dx = -b around the problem's state; six rows per frame.
struct PoseSystem {
  Eigen::MatrixXd H;
  Eigen::VectorXd b;
};

// M^+ of a symmetric positive semi-definite matrix.
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

// Adds the factors [begin, end) of one point, the point eliminated.
void AddPoint(const StereoCamera& camera, const NoiseOptions& noise, const WindowProblem& problem,
              std::size_t begin, std::size_t end, PoseSystem& system) {
  const int n = static_cast<int>(end - begin);
  Eigen::Matrix3d H_pp = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b_p = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, Eigen::Dynamic, 3> H_cp(6 * n, 3);
  for (int i = 0; i < n; ++i) {
    const ReprojectionFactor& factor = problem.factors[begin + i];
    const ReprojectionResidual value =
        EvaluateReprojection(camera, factor.z_px, factor.sqrt_information,
                             problem.world_from_camera[factor.pose], problem.points[factor.point]);
    const double weight = HuberWeight(value.r.squaredNorm(), noise.huber);
    const int at = 6 * factor.pose;
    system.H.block<6, 6>(at, at).noalias() += weight * value.J_pose.transpose() * value.J_pose;
    system.b.segment<6>(at).noalias() += weight * value.J_pose.transpose() * value.r;
    H_cp.middleRows<6>(6 * i).noalias() = weight * value.J_pose.transpose() * value.J_point;
    H_pp.noalias() += weight * value.J_point.transpose() * value.J_point;
    b_p.noalias() += weight * value.J_point.transpose() * value.r;
  }
  const Eigen::Matrix3d inverse = PseudoInverse(H_pp);
  for (int i = 0; i < n; ++i) {
    const Eigen::Matrix<double, 6, 3> left = H_cp.middleRows<6>(6 * i) * inverse;
    const int row = 6 * problem.factors[begin + i].pose;
    system.b.segment<6>(row).noalias() -= left * b_p;
    for (int j = 0; j < n; ++j) {
      const int column = 6 * problem.factors[begin + j].pose;
      system.H.block<6, 6>(row, column).noalias() -= left * H_cp.middleRows<6>(6 * j).transpose();
    }
  }
}

// Adds a prior, linearised anew at the problem's state.
void AddPrior(const WindowProblem& problem, PoseSystem& system) {
  const PosePrior& prior = problem.prior;
  const int n = static_cast<int>(prior.frames.size());
  std::vector<int> pose(n);
  Eigen::VectorXd dx(6 * n);
  Eigen::MatrixXd J = prior.J0;
  for (int i = 0; i < n; ++i) {
    const auto it = std::lower_bound(problem.frames.begin(), problem.frames.end(), prior.frames[i]);
    Require(it != problem.frames.end() && *it == prior.frames[i],
            "Marginalize: the prior names unknown frames");
    pose[i] = static_cast<int>(it - problem.frames.begin());
    dx.segment<6>(6 * i) = problem.world_from_camera[pose[i]].Minus(prior.linearization_point[i]);
    J.middleCols<3>(6 * i) =
        prior.J0.middleCols<3>(6 * i) * InverseRightJacobianSo3(dx.segment<3>(6 * i));
  }
  const Eigen::VectorXd r = prior.r0 + prior.J0 * dx;
  const Eigen::MatrixXd H = J.transpose() * J;
  const Eigen::VectorXd b = J.transpose() * r;
  for (int i = 0; i < n; ++i) {
    system.b.segment<6>(6 * pose[i]) += b.segment<6>(6 * i);
    for (int j = 0; j < n; ++j) {
      system.H.block<6, 6>(6 * pose[i], 6 * pose[j]) += H.block<6, 6>(6 * i, 6 * j);
    }
  }
}

// Frames that the system says something about, the removed one not among them.
std::vector<int> KeptPoses(const WindowProblem& problem, FrameId removed,
                           const PoseSystem& system) {
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(problem.frames.size()); ++i) {
    if (problem.frames[i] == removed) continue;
    if (!system.H.block<6, 6>(6 * i, 6 * i).isZero(0.0)) kept.push_back(i);
  }
  return kept;
}

// The system over `kept`, the pose `removed` (an index, or -1) eliminated.
PoseSystem Reduce(const PoseSystem& system, const std::vector<int>& kept, int removed) {
  const int n = static_cast<int>(kept.size());
  PoseSystem reduced{Eigen::MatrixXd(6 * n, 6 * n), Eigen::VectorXd(6 * n)};
  Eigen::MatrixXd H_kr = Eigen::MatrixXd::Zero(6 * n, 6);
  for (int i = 0; i < n; ++i) {
    reduced.b.segment<6>(6 * i) = system.b.segment<6>(6 * kept[i]);
    if (removed >= 0) H_kr.middleRows<6>(6 * i) = system.H.block<6, 6>(6 * kept[i], 6 * removed);
    for (int j = 0; j < n; ++j) {
      reduced.H.block<6, 6>(6 * i, 6 * j) = system.H.block<6, 6>(6 * kept[i], 6 * kept[j]);
    }
  }
  if (removed >= 0) {
    const Eigen::MatrixXd inverse = PseudoInverse(system.H.block<6, 6>(6 * removed, 6 * removed));
    reduced.H -= H_kr * inverse * H_kr.transpose();
    reduced.b -= H_kr * inverse * system.b.segment<6>(6 * removed);
  }
  return reduced;
}

// H = J0^T J0 and b = J0^T r0: H is singular, so its square root comes from its eigenvectors.
void TakeSquareRoot(const PoseSystem& system, PosePrior& prior) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 *
                                                             (system.H + system.H.transpose()));
  const Eigen::VectorXd& values = eigen.eigenvalues();  // ascending
  const double smallest = kRelativeRank * values[values.size() - 1];
  const Eigen::Index first = (values.array() <= smallest).count();
  const Eigen::Index rank = values.size() - first;
  const Eigen::VectorXd roots = values.tail(rank).cwiseSqrt();
  const Eigen::MatrixXd V_transposed = eigen.eigenvectors().rightCols(rank).transpose();
  prior.J0 = roots.asDiagonal() * V_transposed;
  prior.r0 = roots.cwiseInverse().asDiagonal() * V_transposed * system.b;
}

}  // namespace

PosePrior Marginalize(const StereoCamera& camera, const NoiseOptions& noise,
                      const WindowProblem& problem, FrameId removed) {
  const int size = 6 * static_cast<int>(problem.frames.size());
  PoseSystem system{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  for (std::size_t begin = 0; begin < problem.factors.size();) {
    std::size_t end = begin;
    while (end < problem.factors.size() &&
           problem.factors[end].point == problem.factors[begin].point) {
      ++end;
    }
    AddPoint(camera, noise, problem, begin, end, system);
    begin = end;
  }
  if (!problem.prior.empty()) AddPrior(problem, system);

  PosePrior prior;
  const std::vector<int> kept = KeptPoses(problem, removed, system);
  if (kept.empty()) return prior;
  const auto it = std::find(problem.frames.begin(), problem.frames.end(), removed);
  const int removed_pose =
      it == problem.frames.end() ? -1 : static_cast<int>(it - problem.frames.begin());
  TakeSquareRoot(Reduce(system, kept, removed_pose), prior);
  if (prior.r0.size() == 0) return prior;
  for (const int i : kept) {
    prior.frames.push_back(problem.frames[i]);
    prior.linearization_point.push_back(problem.world_from_camera[i]);
  }
  return prior;
}

}  // namespace cvo
