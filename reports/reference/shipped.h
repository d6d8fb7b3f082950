// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::reports {

// A file of reference figures: where it lies in the sources, and its JSON.
struct ReferenceFile {
  std::string name;
  std::string content;
};

// What others publish, and what we measured of them.
std::vector<ReferenceFile> ShippedReferenceFiles();

}  // namespace cvo::reports
