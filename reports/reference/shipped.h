// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::reports {

// A file of reference figures: its path in the source tree, and its JSON.
struct ReferenceFile {
  std::string name;
  std::string content;
};

// The results that others publish, and those that we measured of their systems.
std::vector<ReferenceFile> ShippedReferenceFiles();

}  // namespace cvo::reports
