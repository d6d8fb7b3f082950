// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/window_problem.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/solvers/reprojection_cost.h"

namespace cvo {

WindowProblem MakeFrames(const Window& window) {
  WindowProblem problem;
  problem.camera = window.camera;
  problem.prior = window.prior;
  for (const WindowFrame* frame : window.Frames()) {
    problem.frames.push_back(frame->id);
    problem.world_from_camera.push_back(frame->world_from_camera);
  }
  problem.is_fixed.assign(problem.frames.size(), 0);
  return problem;
}

void AddLandmark(const Landmark& landmark, const FeatureNoise& noise, WindowProblem& problem) {
  const int point = static_cast<int>(problem.points.size());
  problem.points.push_back(landmark.p_in_object);
  for (const Observation& observation : landmark.observations) {
    problem.factors.push_back({FrameIndex(problem, observation.frame), point, observation.z_px,
                               noise.SqrtInformation(observation)});
  }
}

std::vector<int> SelectLandmarks(const Window& window, int max_points) {
  std::vector<int> selected;
  for (int i = 0; i < static_cast<int>(window.landmarks.size()); ++i) {
    if (window.landmarks[i].observations.size() >= 2) selected.push_back(i);
  }
  if (static_cast<int>(selected.size()) > max_points) {
    std::stable_sort(selected.begin(), selected.end(), [&](int a, int b) {
      return window.landmarks[a].observations.size() > window.landmarks[b].observations.size();
    });
    selected.resize(static_cast<std::size_t>(max_points));
    std::sort(selected.begin(), selected.end());
  }
  return selected;
}

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

namespace {

// Coefficients of a polynomial over X/Z, Y/Z.
enum Monomial { kX, kY, kXX, kXY, kYY };

// Maps coefficients in FieldBasis to those of the monomials, without the constant.
Eigen::Matrix<double, 5, 6> RayCoefficients(const StereoCamera& camera) {
  const FieldBasis center = camera.BasisAt(camera.cx, camera.cy);
  const double x0 = center.value[1];
  const double y0 = center.value[2];
  const double a = camera.fx * center.by_u[1];  // dx / d(X/Z)
  const double b = camera.fy * center.by_v[2];
  Eigen::Matrix<double, 5, 6> T = Eigen::Matrix<double, 5, 6>::Zero();
  T.row(kX) << 0.0, a, 0.0, 2.0 * a * x0, a * y0, 0.0;
  T.row(kY) << 0.0, 0.0, b, 0.0, b * x0, 2.0 * b * y0;
  T(kXX, 3) = a * a;
  T(kXY, 4) = a * b;
  T(kYY, 5) = b * b;
  return T;
}

}  // namespace

std::vector<RowOffset> RowOffsets(const std::vector<StereoFeature>& features, double scale_factor) {
  std::vector<RowOffset> offsets;
  offsets.reserve(features.size());
  for (const StereoFeature& feature : features) {
    if (std::isnan(feature.row_offset_px)) continue;
    offsets.push_back({feature.z_px[0], feature.z_px[1], feature.z_px[0] - feature.z_px[2],
                       feature.row_offset_px, RowSigma(std::pow(scale_factor, feature.octave))});
  }
  return offsets;
}

void AppendRowEvidence(const RowField& rows, const StereoCamera& camera, double deviation_px,
                       WindowPrior& prior) {
  const Eigen::Matrix<double, 5, 6> T = RayCoefficients(camera);
  using Relations = Eigen::Matrix<double, 4, 6>;
  Relations of_columns;
  of_columns << T.row(kX), T.row(kY), T.row(kXX) - T.row(kYY), T.row(kXY);
  Relations of_rows;
  of_rows << T.row(kY), -T.row(kX), T.row(kXY), T.row(kYY) - T.row(kXX);
  Matrix6d covariance = rows.Covariance().topLeftCorner<6, 6>();
  covariance.diagonal().array() += deviation_px * deviation_px;
  const Eigen::LLT<Eigen::Matrix4d> root((of_rows * covariance * of_rows.transpose()).eval());
  const Eigen::Vector4d difference =
      of_columns * prior.right_field_point_px - of_rows * rows.coefficients().head<6>();
  const Eigen::Index n = prior.r0.size();
  prior.J0.conservativeResize(n + 4, Eigen::NoChange);
  prior.J0.bottomRows<4>().setZero();
  prior.J0.bottomRightCorner<4, 6>() = root.matrixL().solve(of_columns);
  prior.r0.conservativeResize(n + 4);
  prior.r0.tail<4>() = root.matrixL().solve(difference);
}

}  // namespace cvo
