// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "experiments/cli/run/sequence_flags.h"

namespace cvo {

// clustervo eval --sequence: scores the results of another system on a sequence against its ground
// truth.
struct EvalSequence {
  SequenceFlags flags;
  std::string objects;
  std::string name;
  std::string output;
  double right_shift_px = 0.0;

  void AddTo(CLI::App& app);
  // Names of the flags that have no meaning without --sequence.
  static std::vector<std::string> FlagNames();
};

// Prints the scores, or result.json if `json`. Writes result.json if an output folder is given.
int EvaluateSequence(const EvalSequence& eval, const std::string& estimate, bool json);

}  // namespace cvo
