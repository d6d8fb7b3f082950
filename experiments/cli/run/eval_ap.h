// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace cvo {

// clustervo eval --ap: KITTI's average precision of boxes.
struct EvalAp {
  bool wanted = false;
  std::string category = "Car";
  std::optional<double> least_overlap;  // default: the benchmark's of the class
  std::string truncation = "applied";
  std::string dont_care = "2d";

  void AddTo(CLI::App& app);
  // Of the flags that mean nothing without --ap.
  static std::vector<std::string> FlagNames();
};

// Prints a table, or JSON, of the boxes of `estimate` against those of `labels`. `frames`: "A:B" or
// empty.
int EvaluateApOfFiles(const EvalAp& eval, const std::string& labels, const std::string& estimate,
                      const std::string& frames, bool json);

}  // namespace cvo
