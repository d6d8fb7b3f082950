// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/cluster_optimization.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/clustering/point_extent.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

std::vector<PointMeasurement> MeasurementsOf(const FeatureNoise& noise,
                                             const std::vector<Landmark>& landmarks,
                                             std::span<const StereoFeature> features,
                                             const std::vector<Match>& matches) {
  std::vector<PointMeasurement> measurements;
  measurements.reserve(matches.size());
  for (const Match& match : matches) {
    const StereoFeature& feature = features[match.feature];
    measurements.push_back(
        {landmarks[match.landmark].p_in_object, feature.z_px, noise.SqrtInformation(feature)});
  }
  return measurements;
}

namespace {

// Returns the upper Cholesky factor U with U^T U = information.
Eigen::Matrix3d SquareRoot(const Eigen::Matrix3d& information) {
  return Eigen::LLT<Eigen::Matrix3d>(information).matrixU();
}

void AddFrames(const Window& window, const Cluster& cluster, ClusterSelection& selection) {
  for (int i = 0; i < static_cast<int>(cluster.states.size()); ++i) {
    const ClusterState& state = cluster.states[i];
    const WindowFrame* frame = window.Find(state.frame);
    if (!frame) continue;
    ClusterProblem& problem = selection.problem;
    selection.states.push_back(i);
    problem.world_from_camera.push_back(frame->world_from_camera);
    problem.time_s.push_back(
        SecondsBetween(cluster.states.front().timestamp_ns, state.timestamp_ns));
    problem.world_from_object.push_back(state.world_from_object);
    problem.velocity_m_s.push_back(state.velocity_m_s);
  }
}

// Adds the landmark's observations in the problem's frames as factors of the point that is added
// next. Observations and states are both in temporal order.
void AddFactors(const FeatureNoise& noise, const Cluster& cluster, const std::vector<int>& states,
                const Landmark& landmark, ClusterProblem& problem) {
  const int point = static_cast<int>(problem.points.size());
  std::size_t pose = 0;
  for (const Observation& seen : landmark.observations) {
    while (pose < states.size() && cluster.states[states[pose]].frame < seen.frame) ++pose;
    if (pose == states.size()) return;
    if (cluster.states[states[pose]].frame != seen.frame) continue;
    problem.factors.push_back(
        {static_cast<int>(pose), point, seen.z_px, noise.SqrtInformation(seen)});
  }
}

}  // namespace

ClusterSelection SelectCluster(const FeatureNoise& noise, const Window& window,
                               const Cluster& cluster) {
  ClusterSelection selection;
  ClusterProblem& problem = selection.problem;
  problem.camera = window.camera;
  AddFrames(window, cluster, selection);
  for (int i = 0; i < static_cast<int>(cluster.landmarks.size()); ++i) {
    const Landmark& landmark = cluster.landmarks[i];
    const bool has_past = !landmark.past_information.isZero();
    const std::size_t before = problem.factors.size();
    AddFactors(noise, cluster, selection.states, landmark, problem);
    const std::size_t added = problem.factors.size() - before;
    if (added == 0 || (added < 2 && !has_past)) {
      problem.factors.resize(before);
      continue;
    }
    selection.landmarks.push_back(i);
    problem.points.push_back(landmark.p_in_object);
    PointPrior prior;
    if (has_past) prior = {landmark.past_mean_in_object, SquareRoot(landmark.past_information)};
    problem.point_priors.push_back(prior);
  }
  return selection;
}

void ApplyClusterSolution(double gate, const ClusterSelection& selection, Cluster& cluster) {
  const ClusterProblem& problem = selection.problem;
  std::vector<RigidTransform> camera_from_object;
  for (std::size_t k = 0; k < selection.states.size(); ++k) {
    ClusterState& state = cluster.states[selection.states[k]];
    state.world_from_object = problem.world_from_object[k];
    state.velocity_m_s = problem.velocity_m_s[k];
    camera_from_object.push_back(problem.world_from_camera[k].Inverse() *
                                 problem.world_from_object[k]);
  }
  for (std::size_t k = 0; k < selection.landmarks.size(); ++k) {
    Landmark& landmark = cluster.landmarks[selection.landmarks[k]];
    landmark.p_in_object = problem.points[k];
  }
  for (const ReprojectionFactor& factor : problem.factors) {
    const PointMeasurement m{problem.points[factor.point], factor.z_px, factor.sqrt_information};
    const auto error = WhitenedError(problem.camera, m, camera_from_object[factor.pose]);
    if (error && error->squaredNorm() <= gate) continue;
    const FrameId frame = cluster.states[selection.states[factor.pose]].frame;
    std::erase_if(cluster.landmarks[selection.landmarks[factor.point]].observations,
                  [&](const Observation& seen) { return seen.frame == frame; });
  }
  std::erase_if(cluster.landmarks, [](const Landmark& landmark) {
    return landmark.observations.empty() && landmark.past_information.isZero();
  });
}

namespace {

// Whether all states that the cluster ever had are still there.
bool HasFirstState(const ClusterMap& map, const Cluster& cluster) {
  const auto found = map.trajectories.find(cluster.id);
  if (found == map.trajectories.end() || found->second.poses.empty()) return true;
  return found->second.poses.front().frame >= cluster.states.front().frame.value;
}

// Moves the solved body frame such that the landmarks keep their places in it, by the median of
// their steps. The held pose is otherwise the first one, and if that is wrong, all landmarks move
// instead of it, away from the places that boxes, past information and unsolved landmarks have.
void KeepLandmarks(const Cluster& cluster, ClusterSelection& selection) {
  ClusterProblem& problem = selection.problem;
  std::vector<Eigen::Vector3d> steps;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    steps.push_back(problem.points[i] - cluster.landmarks[selection.landmarks[i]].p_in_object);
  }
  const Eigen::Vector3d step = MedianPoint(steps);
  const RigidTransform old_from_new(Eigen::Quaterniond::Identity(), step);
  for (Eigen::Vector3d& p : problem.points) p -= step;
  for (RigidTransform& pose : problem.world_from_object) pose = pose * old_from_new;
}

}  // namespace

SolverEndings OptimizeClusters(const Options& options, const EnergySteps& steps,
                               const Window& window, TaskPool& pool, ClusterMap& map) {
  SolverEndings total;
  if (window.temporal.empty()) return total;
  const FrameId newest = window.temporal.back().id;
  std::vector<SolverEndings> endings(map.live.size());
  pool.ParallelFor(static_cast<int>(map.live.size()), [&](int q) {
    if (map.live[q].last_observed != newest) return;
    ClusterSelection selection = SelectCluster(options.NoiseOfFeatures(), window, map.live[q]);
    if (selection.landmarks.empty()) return;
    ClusterProblem& problem = selection.problem;
    const MotionPriorSteps prior = steps.prior(options.motion_prior, problem);
    endings[q].Count(steps.solve_cluster(options.noise, options.solver, prior, problem).ending);
    if (HasFirstState(map, map.live[q])) KeepLandmarks(map.live[q], selection);
    ApplyClusterSolution(steps.gate(options.noise), selection, map.live[q]);
  });
  for (const SolverEndings& of_cluster : endings) total += of_cluster;
  return total;
}

}  // namespace cvo
