// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace cvo {

// Another system's trajectory on a shipped scene, from a file of reports/reference/trajectories.
struct ShippedTrajectory {
  std::string_view system;
  std::string_view scene;
  std::string_view text;  // TUM poses after a line with the hash of the scene file
};
const std::vector<ShippedTrajectory>& ShippedTrajectories();

}  // namespace cvo
