// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "core/base/task_pool.h"
#include "tests/support/moving_world.h"
#include "variants/registry.h"

namespace cvo::test {

// The output of a variant for a world, per frame and at the end of the run.
struct ClusterRun {
  std::vector<WorldView> views;  // as the variant saw them
  std::vector<FrameReport> reports;
  std::vector<RigidTransform> trajectory;
  std::vector<ClusterTrajectory> clusters;
};

struct RunSettings {
  int frames = 30;
  double noise_px = 0.3;
  int threads = 1;
  std::uint64_t seed = 0;
  Options options;
};

// Runs a variant on a world. `change(frame, view)` may modify a view before the variant processes
// it; a view whose timestamp it makes negative is skipped.
template <typename Change>
ClusterRun RunClusters(std::string_view variant, const MovingWorld& world,
                       const RunSettings& settings, Change change) {
  TaskPool pool(settings.threads);
  const auto odometry =
      FindVariant(variant).make({world.camera(), settings.options, settings.seed}, pool);
  ClusterRun run;
  StageTimes times;
  for (int i = 0; i < settings.frames; ++i) {
    WorldView view = world.Observe(i, settings.noise_px);
    change(i, view);
    const bool is_skipped = view.frame.timestamp_ns < 0;
    run.reports.push_back(is_skipped ? odometry->Skip(MovingWorld::TimeOf(i))
                                     : odometry->Process(view.frame, times));
    run.views.push_back(std::move(view));
  }
  run.trajectory = odometry->Trajectory();
  run.clusters = odometry->ClusterTrajectories();
  return run;
}

// Converts the body numbers of a WorldView to the ids that ground-truth labels use.
inline std::vector<BodyId> BodyIds(const std::vector<int>& bodies) {
  std::vector<BodyId> ids;
  for (const int body : bodies) ids.push_back(BodyId{body});
  return ids;
}

inline const auto kNoChange = [](int, WorldView&) {};

// Returns the non-static cluster with most of the body's features in the frame; invalid if none.
inline ClusterId ClusterOfBody(const ClusterRun& run, int frame, int body) {
  std::map<ClusterId, int> votes;
  for (const LandmarkReport& landmark : run.reports[frame].landmarks) {
    if (run.views[frame].of_body[landmark.feature] == body) ++votes[landmark.cluster];
  }
  ClusterId best;
  for (const auto& [id, count] : votes) {
    if (id > kStaticScene && (!best.valid() || count > votes[best])) best = id;
  }
  return best;
}

inline const ClusterReport* FindReport(const FrameReport& report, ClusterId id) {
  for (const ClusterReport& cluster : report.clusters) {
    if (cluster.id == id) return &cluster;
  }
  return nullptr;
}

inline const ClusterTrajectory* FindTrajectory(const ClusterRun& run, ClusterId id) {
  for (const ClusterTrajectory& cluster : run.clusters) {
    if (cluster.id == id) return &cluster;
  }
  return nullptr;
}

// Returns the ids of all clusters reported in any frame.
inline std::set<ClusterId> ReportedIds(const ClusterRun& run) {
  std::set<ClusterId> ids;
  for (const FrameReport& report : run.reports) {
    for (const ClusterReport& cluster : report.clusters) ids.insert(cluster.id);
  }
  return ids;
}

}  // namespace cvo::test
