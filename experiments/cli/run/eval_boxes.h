// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace cvo {

// clustervo eval --ap and --tracking: scores boxes in KITTI's file formats as KITTI's benchmarks
// do.
struct EvalBoxes {
  bool ap = false;
  bool tracking = false;
  std::string category = "Car";
  std::optional<double> least_overlap;  // default: the benchmark's for the class
  std::string truncation = "applied";
  std::string dont_care = "2d";

  bool wanted() const { return ap || tracking; }
  void AddTo(CLI::App& app);
  // Throws CLI::ValidationError for flags that do not go together, and for flags that have no
  // effect because no boxes are scored.
  void CheckUsage(const CLI::App& app) const;
};

// The boxes of `estimate` are compared to those of `labels`. `frames`: "A:B" or empty.
struct BoxFiles {
  std::string labels;
  std::string estimate;
  std::string frames;
};

// Prints the scores as a table, or as JSON.
int EvaluateBoxes(const EvalBoxes& eval, const BoxFiles& files, bool json);

}  // namespace cvo
