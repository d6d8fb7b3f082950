// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cvo {

struct ShippedSuite {
  std::string name;  // as stated in `text`
  std::string text;  // JSON
};

// The suite files of experiments/configs, compiled in, in their order of listing.
std::vector<ShippedSuite> ShippedSuites();

// The collections of suites (experiments/suite/collection.h).
std::vector<ShippedSuite> ShippedCollections();

// Another system's trajectory on a shipped scene, from a file of reports/reference/trajectories.
struct ShippedTrajectory {
  std::string_view system;
  std::string_view scene;
  std::string_view text;  // TUM poses after a line with the hash of the scene file
};
const std::vector<ShippedTrajectory>& ShippedTrajectories();

}  // namespace cvo
