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

// Poses of clusters as last estimated. Like the frames of a FrameLog they are stored in a Spool; a
// second Spool holds the position of each of them.
class PoseLog {
 public:
  // `folder`: of both Spools.
  explicit PoseLog(const std::filesystem::path& folder = {}) : poses_(folder), entries_(folder) {}
  PoseLog(const std::vector<ClusterTrajectory>& clusters);  // NOLINT(google-explicit-constructor)

  // Adds clusters, even those without poses, and their poses. Poses of one cluster may come in
  // several calls.
  void Add(const std::vector<ClusterTrajectory>& clusters);

  const std::set<ClusterId>& clusters() const { return clusters_; }

  struct Entry {
    std::int32_t frame = 0;  // see ClusterPose::frame
    std::int32_t cluster = 0;
    std::uint64_t begin = 0;
    std::uint64_t size = 0;

    ClusterId id() const { return ClusterId{cluster}; }
  };
  // Index entries of all poses: by frame and then by id, or by id and then by frame.
  std::vector<Entry> ByFrame() const;
  std::vector<Entry> ByCluster() const;
  ClusterPose Read(const Entry& entry) const;

 private:
  std::vector<Entry> Entries() const;

  Spool poses_;
  Spool entries_;
  std::set<ClusterId> clusters_;
};

}  // namespace cvo
