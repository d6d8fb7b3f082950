// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/camera_solver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace cvo {

namespace {

// Factor on the gate for a pose that is nearly right, such as a RANSAC hypothesis: a minimal sample
// carries the noise of its three points (two standard deviations of the sample for one of the
// measurement).
constexpr double kHypothesisGate = 4.0;

std::array<std::size_t, 3> DrawSample(std::size_t n, Rng& rng) {
  std::array<std::size_t, 3> sample{};
  sample[0] = rng.UniformInt(n);
  do sample[1] = rng.UniformInt(n);
  while (sample[1] == sample[0]);
  do sample[2] = rng.UniformInt(n);
  while (sample[2] == sample[0] || sample[2] == sample[1]);
  return sample;
}

// Empty if one of the measurements cannot be triangulated.
std::optional<RigidTransform> AlignSample(const StereoCamera& camera,
                                          std::span<const PointMeasurement> measurements,
                                          const std::array<std::size_t, 3>& sample) {
  Eigen::Matrix3Xd in_camera(3, 3);
  Eigen::Matrix3Xd in_world(3, 3);
  for (int k = 0; k < 3; ++k) {
    const PointMeasurement& measurement = measurements[sample[k]];
    const auto point = camera.BackProject(measurement.z_px);
    if (!point) return std::nullopt;
    in_camera.col(k) = *point;
    in_world.col(k) = measurement.p_in_world;
  }
  return AlignPoints(in_camera, in_world);
}

}  // namespace

std::optional<CameraSolution> SolveCameraRansac(const StereoCamera& camera,
                                                std::span<const PointMeasurement> measurements,
                                                const NoiseOptions& noise,
                                                std::span<const int> cubes, int iterations,
                                                int min_inliers, Rng& rng) {
  if (measurements.size() < 3) return std::nullopt;
  CameraSolution best;
  int best_support = 0;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const auto world_from_camera =
        AlignSample(camera, measurements, DrawSample(measurements.size(), rng));
    if (!world_from_camera) continue;
    CameraSolution agreeing = ClassifyMeasurements(camera, measurements, *world_from_camera,
                                                   kHypothesisGate * noise.gate);
    const int supported = cubes.empty() ? agreeing.inliers : CountCubes(cubes, agreeing.is_inlier);
    if (agreeing.inliers >= 3 && supported > best_support) {
      best_support = supported;
      best = std::move(agreeing);
    }
  }
  if (best_support == 0) return std::nullopt;
  CameraSolution solution = RefineCamera(camera, measurements, best.world_from_camera, noise);
  if (solution.inliers < min_inliers) return std::nullopt;
  return solution;
}

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

std::vector<int> CubesOf(const StereoCamera& camera,
                         std::span<const PointMeasurement> measurements) {
  constexpr double kSide = 4.0;  // baselines
  std::map<std::array<double, 3>, int> numbers;
  std::vector<int> cubes;
  for (const PointMeasurement& measurement : measurements) {
    const Eigen::Vector3d at =
        (measurement.p_in_world / (kSide * camera.baseline_m)).array().floor();
    const int next = static_cast<int>(numbers.size());
    cubes.push_back(numbers.try_emplace({at[0], at[1], at[2]}, next).first->second);
  }
  return cubes;
}

int CountCubes(std::span<const int> cubes, std::span<const char> is_inlier) {
  std::vector<char> is_counted(cubes.size(), 0);
  int count = 0;
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    if (is_inlier[i] && !std::exchange(is_counted[cubes[i]], 1)) ++count;
  }
  return count;
}

namespace {

// The first round uses the inliers of `solution`.
CameraSolution Solve(const StereoCamera& camera, std::span<const PointMeasurement> measurements,
                     CameraSolution solution, const NoiseOptions& noise) {
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

}  // namespace

CameraSolution SolveCamera(const StereoCamera& camera,
                           std::span<const PointMeasurement> measurements,
                           const RigidTransform& initial, const NoiseOptions& noise) {
  return Solve(camera, measurements, {initial, std::vector<char>(measurements.size(), 1)}, noise);
}

CameraSolution RefineCamera(const StereoCamera& camera,
                            std::span<const PointMeasurement> measurements,
                            const RigidTransform& initial, const NoiseOptions& noise) {
  return Solve(camera, measurements,
               ClassifyMeasurements(camera, measurements, initial, kHypothesisGate * noise.gate),
               noise);
}

}  // namespace cvo
