// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "experiments/cli/run/sequence_flags.h"

namespace cvo {

// clustervo eval --sequence: what another system made of a sequence, against its truth.
struct EvalSequence {
  SequenceFlags flags;
  std::string objects;
  std::string name;
  std::string output;
  double right_shift_px = 0.0;

  void AddTo(CLI::App& app);
  // Of the flags that mean nothing without --sequence.
  static std::vector<std::string> FlagNames();
};

// Prints the scores, or result.json with `json`; writes it where there is an output folder.
int EvaluateSequence(const EvalSequence& eval, const std::string& estimate, bool json);

}  // namespace cvo
