// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/log/pose_log.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "experiments/log/pack_frames.h"
#include "experiments/log/packed.h"

namespace cvo {

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
  std::vector<Entry> entries = entries_;
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.frame, a.cluster) < std::tie(b.frame, b.cluster);
  });
  return entries;
}

std::vector<PoseLog::Entry> PoseLog::ByCluster() const {
  std::vector<Entry> entries = entries_;
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.cluster, a.frame) < std::tie(b.cluster, b.frame);
  });
  return entries;
}

ClusterPose PoseLog::Read(const Entry& entry) const {
  const std::string bytes = spool_.Read(entry.begin, entry.size);
  ClusterPose pose;
  Unpacker{bytes}(pose);
  return pose;
}

}  // namespace cvo
