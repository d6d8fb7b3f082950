// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/association.h"

#include <algorithm>
#include <tuple>

#include "core/base/error.h"

namespace cvo {
namespace {

using Candidate = std::tuple<std::int64_t, std::size_t, std::size_t>;  // |dt|, a, b

void CheckIncreasing(const Trajectory& trajectory) {
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    Require(trajectory[i - 1].timestamp_ns < trajectory[i].timestamp_ns,
            "AssociateByTime: timestamps must increase");
  }
}

std::vector<Candidate> FindCandidates(const Trajectory& a, const Trajectory& b,
                                      std::int64_t tolerance_ns) {
  std::vector<Candidate> candidates;
  std::size_t first = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::int64_t time_ns = a[i].timestamp_ns;
    while (first < b.size() && b[first].timestamp_ns < time_ns - tolerance_ns) ++first;
    for (std::size_t j = first; j < b.size() && b[j].timestamp_ns <= time_ns + tolerance_ns; ++j) {
      const std::int64_t distance_ns = b[j].timestamp_ns - time_ns;
      candidates.emplace_back(distance_ns < 0 ? -distance_ns : distance_ns, i, j);
    }
  }
  return candidates;
}

}  // namespace

TimeAssociation AssociateByTime(const Trajectory& a, const Trajectory& b,
                                std::int64_t tolerance_ns) {
  Require(tolerance_ns >= 0, "AssociateByTime: the tolerance must not be negative");
  CheckIncreasing(a);
  CheckIncreasing(b);
  std::vector<Candidate> candidates = FindCandidates(a, b, tolerance_ns);
  std::sort(candidates.begin(), candidates.end());
  std::vector<bool> taken_a(a.size()), taken_b(b.size());
  TimeAssociation association;
  for (const auto& [distance_ns, i, j] : candidates) {
    if (taken_a[i] || taken_b[j]) continue;
    taken_a[i] = taken_b[j] = true;
    association.pairs.emplace_back(i, j);
  }
  std::sort(association.pairs.begin(), association.pairs.end());
  association.unmatched_a = a.size() - association.pairs.size();
  association.unmatched_b = b.size() - association.pairs.size();
  return association;
}

std::vector<std::optional<RigidTransform>> PosesAtFrames(const TimeAssociation& truth_estimate,
                                                         std::size_t truth_frames,
                                                         const Trajectory& estimate) {
  std::vector<std::optional<RigidTransform>> poses(truth_frames);
  for (const auto& [frame, index] : truth_estimate.pairs) {
    Require(frame < truth_frames && index < estimate.size(), "PosesAtFrames: index out of range");
    poses[frame] = estimate[index].world_from_camera;
  }
  return poses;
}

}  // namespace cvo
