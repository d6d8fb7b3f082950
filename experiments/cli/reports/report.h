// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo {

struct ReportFlags {
  std::string folder;
  std::vector<std::string> runs = {};  // on one sequence, instead of a suite's folder
  std::string out = {};                // empty: the subfolder "report"
  std::string against = {};
  int every = 0;
  bool no_images = false;
  bool all_images = false;
};

// Writes the page of a suite's results. Returns 1 if a whole section could not be made, else 0.
int WriteReport(const ReportFlags& flags);

}  // namespace cvo
