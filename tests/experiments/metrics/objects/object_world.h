// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small ground truths and estimates of them for the tests of the object metrics.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/objects/object_scores.h"

namespace cvo::test {

inline RigidTransform Pose(const Eigen::Vector3d& rotation, const Eigen::Vector3d& translation) {
  return {ExpSo3(rotation), translation};
}
inline RigidTransform At(double x, double y = 0.0, double z = 0.0) {
  return Pose(Eigen::Vector3d::Zero(), {x, y, z});
}
inline Eigen::Vector3d RandomVector(Rng& rng, double scale) {
  return scale * Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal());
}

constexpr std::int64_t kFrame_ns = 100'000'000;

// Ground truth of `frames` frames at 10 Hz, with a stationary camera at the origin and no bodies.
inline ObjectTruth TruthOf(int frames) {
  ObjectTruth truth;
  truth.contract.truth = reports::TruthSource::kScene;
  truth.contract.visible = reports::Visibility{reports::VisibleBy::kMask, 0, 0};
  truth.mover_travel_m = 0.2;
  for (int k = 0; k < frames; ++k) {
    truth.timestamps_ns.push_back(kFrame_ns * k);
    truth.world_from_camera.push_back(RigidTransform());
  }
  return truth;
}

// Adds a body with these poses (world_from_object), visible in every frame.
inline void AddBody(ObjectTruth& truth, const std::vector<RigidTransform>& poses) {
  TruthBody body;
  body.id = static_cast<int>(truth.bodies.size()) + 1;
  body.name = "body_" + std::to_string(body.id);
  body.category = "Ball";
  for (const RigidTransform& pose : poses) body.frames.push_back(BodyFrame{pose, true});
  truth.bodies.push_back(std::move(body));
  FinishTruth(truth);
}

// Poses that move along x at 1 m per frame.
inline std::vector<RigidTransform> Line(int frames, double y = 0.0) {
  std::vector<RigidTransform> poses;
  for (int k = 0; k < frames; ++k) poses.push_back(At(k, y));
  return poses;
}
// One body that moves along x, in `frames` frames.
inline ObjectTruth OneMover(int frames) {
  ObjectTruth truth = TruthOf(frames);
  AddBody(truth, Line(frames));
  return truth;
}

inline std::vector<RigidTransform> RandomWalk(Rng& rng, int frames) {
  std::vector<RigidTransform> poses = {Pose(RandomVector(rng, 1.0), RandomVector(rng, 3.0))};
  while (static_cast<int>(poses.size()) < frames) {
    poses.push_back(poses.back() * Pose(RandomVector(rng, 0.2), RandomVector(rng, 0.3)));
  }
  return poses;
}

// Adds `count` observations of landmarks of `cluster` that lie on `body`, in one frame.
inline void Observe(ObjectEstimate& estimate, int frame, int cluster, int body, int count = 4) {
  for (int i = 0; i < count; ++i) {
    estimate.landmarks[static_cast<std::size_t>(frame)].push_back(
        {cluster, {static_cast<std::int16_t>(body), PointMotion::kMoving}});
  }
}

// The truth as an estimate: cluster k is body k, with the velocity of the body's origin.
inline ObjectEstimate PerfectEstimate(const ObjectTruth& truth) {
  ObjectEstimate estimate;
  estimate.world_from_camera = truth.world_from_camera;
  estimate.landmarks.resize(truth.frame_count());
  for (const TruthBody& body : truth.bodies) {
    ClusterEstimate cluster{body.id, body.category, {}};
    for (int k = 0; k < static_cast<int>(truth.frame_count()); ++k) {
      const auto& frame = body.frames[static_cast<std::size_t>(k)];
      if (!frame) continue;
      ClusterFrame pose;
      pose.frame = k;
      pose.world_from_object = frame->world_from_object;
      pose.velocity_m_s =
          PointVelocity(truth, body, k, Eigen::Vector3d::Zero()).value_or(Eigen::Vector3d::Zero());
      pose.observed_landmarks = 4;
      cluster.frames.push_back(pose);
      Observe(estimate, k, body.id, body.id);
    }
    estimate.clusters.push_back(std::move(cluster));
  }
  return estimate;
}

// The same estimate expressed in another world frame, and with another object frame per cluster.
inline ObjectEstimate Restate(const ObjectEstimate& estimate,
                              const RigidTransform& other_from_world,
                              const std::vector<RigidTransform>& object_from_other) {
  ObjectEstimate other = estimate;
  for (auto& pose : other.world_from_camera) {
    if (pose) pose = other_from_world * *pose;
  }
  for (std::size_t c = 0; c < other.clusters.size(); ++c) {
    for (ClusterFrame& frame : other.clusters[c].frames) {
      frame.world_from_object = other_from_world * frame.world_from_object * object_from_other[c];
      frame.point_in_object = object_from_other[c].Inverse() * frame.point_in_object;
      frame.velocity_m_s = other_from_world.rotation() * *frame.velocity_m_s;
    }
  }
  return other;
}

// Two bodies and a camera, each on a random walk.
inline ObjectTruth RandomTruth(std::uint64_t seed, int frames) {
  Rng rng(seed, "bodies");
  ObjectTruth truth = TruthOf(frames);
  const std::vector<RigidTransform> camera = RandomWalk(rng, frames);
  truth.world_from_camera.assign(camera.begin(), camera.end());
  AddBody(truth, RandomWalk(rng, frames));
  AddBody(truth, RandomWalk(rng, frames));
  return truth;
}

inline ObjectEstimate Noisy(const ObjectTruth& truth, std::uint64_t seed) {
  Rng rng(seed, "noise");
  ObjectEstimate estimate = PerfectEstimate(truth);
  const auto noise = [&] { return Pose(RandomVector(rng, 0.02), RandomVector(rng, 0.05)); };
  for (auto& pose : estimate.world_from_camera) pose = *pose * noise();
  for (ClusterEstimate& cluster : estimate.clusters) {
    for (ClusterFrame& frame : cluster.frames) {
      frame.world_from_object = frame.world_from_object * noise();
      *frame.velocity_m_s += RandomVector(rng, 0.1);
    }
  }
  return estimate;
}

// A perfect estimate whose first cluster is off by (0, offsets_m[k], 0) in frame k. The alignment
// of the object frame absorbs the mean offset.
inline ObjectEstimate OffBy(const ObjectTruth& truth, const std::vector<double>& offsets_m) {
  ObjectEstimate estimate = PerfectEstimate(truth);
  for (std::size_t k = 0; k < offsets_m.size(); ++k) {
    RigidTransform& pose = estimate.clusters[0].frames[k].world_from_object;
    pose = At(0, offsets_m[k]) * pose;
  }
  return estimate;
}

inline std::vector<Metric> Evaluate(const ObjectTruth& truth, const ObjectEstimate& estimate) {
  return ObjectMetrics(truth, ScoreObjects(truth, estimate));
}

inline double Value(const std::vector<Metric>& metrics, const std::string& name) {
  const Metric* metric = FindMetric(metrics, name);
  return metric == nullptr ? std::nan("") : metric->value;
}

inline std::int64_t Count(const std::vector<Metric>& metrics, const std::string& name) {
  const Metric* metric = FindMetric(metrics, name);
  return metric == nullptr ? -1 : metric->n;
}

// Expects that every metric says what it measures, of how many, and what it leaves out.
inline void ExpectContracts(const std::vector<Metric>& metrics) {
  for (const Metric& metric : metrics) {
    EXPECT_GT(metric.n, 0) << metric.name;
    const reports::Contract& c = metric.contract;
    EXPECT_TRUE(c.subject && c.truth && c.alignment && c.pairing && c.delta && c.aggregation)
        << metric.name;
    EXPECT_FALSE(metric.left_out.empty()) << metric.name;
  }
}

}  // namespace cvo::test
