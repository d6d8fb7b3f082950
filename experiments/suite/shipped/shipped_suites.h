// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
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

}  // namespace cvo
