// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/log/pose_log.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <type_traits>

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
      const Entry entry{static_cast<std::int32_t>(pose.frame),
                        static_cast<std::int32_t>(cluster.id.value), poses_.size(), bytes.size()};
      std::string packed;
      Packer{packed}(entry);
      entries_.Append(packed);
      poses_.Append(bytes);
    }
  }
}

std::vector<PoseLog::Entry> PoseLog::Entries() const {
  static_assert(std::has_unique_object_representations_v<Entry>, "no padding, which is never set");
  std::vector<Entry> entries(entries_.size() / sizeof(Entry));
  const std::string bytes = entries_.Read(0, entries_.size());
  Unpacker unpack{bytes};
  for (Entry& entry : entries) unpack(entry);
  return entries;
}

std::vector<PoseLog::Entry> PoseLog::ByFrame() const {
  return SortedBy(Entries(), [](const Entry& e) { return std::tie(e.frame, e.cluster); });
}

std::vector<PoseLog::Entry> PoseLog::ByCluster() const {
  return SortedBy(Entries(), [](const Entry& e) { return std::tie(e.cluster, e.frame); });
}

ClusterPose PoseLog::Read(const Entry& entry) const {
  const std::string bytes = poses_.Read(entry.begin, entry.size);
  ClusterPose pose;
  Unpacker{bytes}(pose);
  return pose;
}

}  // namespace cvo
