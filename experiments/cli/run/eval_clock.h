// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "experiments/datasets/sequence.h"

namespace cvo {

// clustervo eval --clock-offset: estimates how far the clock of the ground truth is ahead.
struct EvalClock {
  std::optional<double> most_s;

  bool wanted() const { return most_s.has_value(); }
  void AddTo(CLI::App& app);
};

// Print the offset, as JSON if `json`. The first compares two TUM files, the second a sequence and
// an estimate of its camera trajectory.
int EvaluateClock(const EvalClock& eval, const std::string& groundtruth,
                  const std::string& estimate, bool json);
int EvaluateClock(const EvalClock& eval, const SequenceRequest& request,
                  const std::string& estimate, bool json);

}  // namespace cvo
