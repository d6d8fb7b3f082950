// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/log/pose_log.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "experiments/log/pack_frames.h"
#include "experiments/log/packed.h"

namespace cvo {
namespace {

template <typename Key>
std::vector<PoseLog::Entry> SortedBy(std::vector<PoseLog::Entry> entries, const Key& key) {
  std::sort(entries.begin(), entries.end(),
            [&key](const PoseLog::Entry& a, const PoseLog::Entry& b) { return key(a) < key(b); });
  return entries;
}

}  // namespace

PoseLog::PoseLog(const std::vector<ClusterTrajectory>& clusters) { Add(clusters); }

void PoseLog::Add(const std::vector<ClusterTrajectory>& clusters) {
  for (const ClusterTrajectory& cluster : clusters) {
    clusters_.insert(cluster.id);
    for (const ClusterPose& pose : cluster.poses) {
      std::string bytes;
      Packer{bytes}(pose);
      entries_.push_back({static_cast<std::int32_t>(pose.frame),
                          static_cast<std::int32_t>(cluster.id.value), spool_.size(),
                          static_cast<std::uint32_t>(bytes.size())});
      spool_.Append(bytes);
    }
  }
}

std::vector<PoseLog::Entry> PoseLog::ByFrame() const {
  return SortedBy(entries_, [](const Entry& e) { return std::tie(e.frame, e.cluster); });
}

std::vector<PoseLog::Entry> PoseLog::ByCluster() const {
  return SortedBy(entries_, [](const Entry& e) { return std::tie(e.cluster, e.frame); });
}

ClusterPose PoseLog::Read(const Entry& entry) const {
  const std::string bytes = spool_.Read(entry.begin, entry.size);
  ClusterPose pose;
  Unpacker{bytes}(pose);
  return pose;
}

}  // namespace cvo
