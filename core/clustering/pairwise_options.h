// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

struct PairwiseOptions {
  double alpha = 5.0;
  double bandwidth_m = 0.7071;
  int sweeps = 10;
  double tolerance = 1e-3;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("alpha", self.alpha,
                {"nats", 0, 1000,
                 "maximum cost of a landmark's neighbours having another label; larger "
                 "smooths more and swallows small bodies",
                 "paper 4.1; of a normalised kernel, METHOD.md 5.6"});
    visit.Field(
        "bandwidth_m", self.bandwidth_m,
        {"m", 0.01, 100, "standard deviation of the Gaussian that makes two landmarks neighbours",
         "exp(-d^2) of the paper"});
    visit.Field("sweeps", self.sweeps,
                {"1", 1, 1000, "maximum mean-field iterations", "5 to 10 suffice, METHOD.md 5.6"});
    visit.Field(
        "tolerance", self.tolerance,
        {"1", 0, 1, "stop when all probabilities change by less than this; 0: run all iterations",
         "METHOD.md 5.6"});
  }
};

}  // namespace cvo
