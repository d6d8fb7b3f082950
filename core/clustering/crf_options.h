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

// Options of the unary terms of the CRF. Energies are negative log probabilities in nats.
struct UnaryOptions {
  double eta = 0.95;
  double kappa = 2.0;
  double undetected_reach = 1.7;
  double static_energy = 2.0;
  double outlier_energy = 4.0;
  int past_frames = 5;
  double motion_cap = 25.0;
  // Of one term, nats, so that no term overrules the others (METHOD.md 5.2).
  static constexpr double kMaxEnergy = 15.0;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field(
        "eta", self.eta,
        {"1", 0.0, 1.0, "prior probability that a landmark has the label given by the boxes",
         "paper, section 4.1"});
    visit.Field("kappa", self.kappa,
                {"half sizes", 0.1, 100.0,
                 "standard deviation of a body's points; 2 to 2.5 reaches the surface of a box",
                 "METHOD.md 5.4"});
    visit.Field("undetected_reach", self.undetected_reach,
                {"1", 0.0, 100.0,
                 "standard deviations of a body's points up to which a landmark costs nothing in "
                 "the affinity term of a cluster without a detection; 0 as in the paper",
                 "METHOD.md 5.4; the root of 3, the mean square of a body's own points"});
    visit.Field("static_energy", self.static_energy,
                {"nats", 0.0, 100.0,
                 "affinity energy of the static scene: a landmark within sqrt(2 * static_energy) "
                 "standard deviations of a body's centre is assigned to the body",
                 "METHOD.md 5.4, not published"});
    visit.Field("outlier_energy", self.outlier_energy,
                {"nats", 0.0, 100.0, "affinity energy of the outlier class",
                 "METHOD.md 5.4, not published"});
    visit.Field(
        "past_frames", self.past_frames,
        {"frames", 1, 200,
         "frames between the observations that the motion term compares; more detects slower "
         "motion and says nothing of newer landmarks",
         "paper, section 3.2"});
    visit.Field(
        "motion_cap", self.motion_cap,
        {"1", 0.1, 1e6, "maximum squared whitened error; larger gives more weight to single errors",
         "METHOD.md 5.5"});
  }
};

}  // namespace cvo
