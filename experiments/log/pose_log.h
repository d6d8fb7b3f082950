// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <vector>

#include "core/files/spool.h"
#include "core/interface/odometry.h"

namespace cvo {

// Poses of clusters as last estimated, in a Spool as frames are in a FrameLog.
class PoseLog {
 public:
  // `folder`: of the spool.
  explicit PoseLog(std::filesystem::path folder = {}) : spool_(std::move(folder)) {}
  PoseLog(const std::vector<ClusterTrajectory>& clusters);  // NOLINT(google-explicit-constructor)

  // The clusters are known from then on, with these poses and those of other calls.
  void Add(const std::vector<ClusterTrajectory>& clusters);

  const std::set<ClusterId>& clusters() const { return clusters_; }

  struct Entry {
    std::int32_t frame = 0;  // as ClusterPose::frame
    std::int32_t cluster = 0;
    std::uint64_t begin = 0;
    std::uint32_t size = 0;

    ClusterId id() const { return ClusterId{cluster}; }
  };
  // All poses, by frame and then by id, or by id and then by frame.
  std::vector<Entry> ByFrame() const;
  std::vector<Entry> ByCluster() const;
  ClusterPose Read(const Entry& entry) const;

 private:
  Spool spool_;
  std::set<ClusterId> clusters_;
  std::vector<Entry> entries_;
};

}  // namespace cvo
