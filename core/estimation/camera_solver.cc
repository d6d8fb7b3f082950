// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/camera_solver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <bitset>

namespace cvo {
namespace {

constexpr int kRounds = 4;
constexpr int kIterationsPerRound = 5;
constexpr double kSmallStep = 1e-7;  // rad and m

struct NormalEquations {
  Matrix6d H = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();  // J^T r
};

// Adds the J^T J and J^T r of one measurement (tangent of world_from_camera), weighted by the Huber
// loss.
void Accumulate(const StereoCamera& camera, const PointMeasurement& m,
                const Eigen::Matrix3d& camera_from_world_rotation, const Eigen::Vector3d& position,
                double huber, NormalEquations& normal) {
  const Eigen::Vector3d c = camera_from_world_rotation * (m.p_in_world - position);
  const auto projection = camera.Project(c);
  if (!projection) return;
  const Eigen::Vector3d r = m.sqrt_information * (*projection - m.z_px);
  const Eigen::Matrix3d WJ = m.sqrt_information * camera.ProjectionJacobian(c);
  Eigen::Matrix<double, 3, 6> J;
  J << WJ * Skew(c), -WJ * camera_from_world_rotation;
  const double weight = HuberWeight(r.squaredNorm(), huber);
  normal.H.noalias() += weight * J.transpose() * J;
  normal.b.noalias() += weight * J.transpose() * r;
}

}  // namespace

std::optional<Eigen::Vector3d> WhitenedError(const StereoCamera& camera, const PointMeasurement& m,
                                             const RigidTransform& camera_from_world) {
  const auto projection = camera.Project(camera_from_world * m.p_in_world);
  if (!projection) return std::nullopt;
  return m.sqrt_information * (*projection - m.z_px);
}

CameraSolution ClassifyMeasurements(const StereoCamera& camera,
                                    std::span<const PointMeasurement> measurements,
                                    const RigidTransform& world_from_camera, double gate) {
  CameraSolution solution{world_from_camera, std::vector<char>(measurements.size(), 0), 0};
  const RigidTransform camera_from_world = world_from_camera.Inverse();
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    const auto error = WhitenedError(camera, measurements[i], camera_from_world);
    solution.is_inlier[i] = error && error->squaredNorm() <= gate;
    solution.inliers += solution.is_inlier[i];
  }
  return solution;
}

int CoveredCells(const StereoCamera& camera, std::span<const PointMeasurement> measurements,
                 std::span<const char> is_inlier) {
  constexpr int kSide = 12;
  const auto cell = [](double z_px, int size_px) {
    return std::clamp(static_cast<int>(z_px * kSide / size_px), 0, kSide - 1);
  };
  std::bitset<kSide * kSide> covered;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (!is_inlier[i]) continue;
    const Eigen::Vector3d& z_px = measurements[i].z_px;
    const int index = kSide * cell(z_px[1], camera.height_px) + cell(z_px[0], camera.width_px);
    covered.set(static_cast<std::size_t>(index));
  }
  return static_cast<int>(covered.count());
}

CameraSolution SolveCamera(const StereoCamera& camera,
                           std::span<const PointMeasurement> measurements,
                           const RigidTransform& initial, const NoiseOptions& noise) {
  CameraSolution solution;
  solution.world_from_camera = initial;
  solution.is_inlier.assign(measurements.size(), 1);
  for (int round = 0; round < kRounds; ++round) {
    for (int iteration = 0; iteration < kIterationsPerRound; ++iteration) {
      const Eigen::Matrix3d R = solution.world_from_camera.RotationMatrix().transpose();
      const Eigen::Vector3d position = solution.world_from_camera.translation();
      NormalEquations normal;
      for (std::size_t i = 0; i < measurements.size(); ++i) {
        if (solution.is_inlier[i]) {
          Accumulate(camera, measurements[i], R, position, noise.huber, normal);
        }
      }
      const Eigen::LDLT<Matrix6d> factor(normal.H);
      const Vector6d step = factor.solve(-normal.b);
      if (factor.info() != Eigen::Success || !factor.isPositive() || !step.allFinite()) break;
      solution.world_from_camera = solution.world_from_camera.Plus(step);
      if (step.norm() < kSmallStep) break;
    }
    solution = ClassifyMeasurements(camera, measurements, solution.world_from_camera, noise.gate);
  }
  return solution;
}

}  // namespace cvo
