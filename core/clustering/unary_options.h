// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

// The unary terms of the CRF. Energies are in nats: minus the logarithm of a probability.
struct UnaryOptions {
  double eta = 0.95;
  double box_shrink = 0.05;
  double box_foot = 0.2;
  double kappa = 2.0;
  double static_energy = 1.0;
  double outlier_energy = 4.0;
  int past_frames = 14;
  double motion_cap = 25.0;
  double neutral_motion = 1.5;
  double outlier_motion = 4.5;
  double max_energy = 15.0;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("eta", self.eta,
                {"1", 0.0, 1.0, "probability that a landmark belongs where the boxes say",
                 "paper, section 4.1"});
    visit.Field("box_shrink", self.box_shrink,
                {"1", 0.0, 0.49,
                 "share of its width and height by which each side of a detection moves inwards: "
                 "its rim is background",
                 "METHOD.md 5.3"});
    visit.Field("box_foot", self.box_foot,
                {"1", 0.0, 1.0,
                 "share of a detection's height, from below, in which a landmark may as well be of "
                 "the static scene: what a body stands on is seen there, between legs or wheels; 0 "
                 "is the paper's",
                 "chosen from 0 ... 0.35 on the rooms: half of the background that bodies took was "
                 "in this part of their boxes"});
    visit.Field("kappa", self.kappa,
                {"half sizes", 0.1, 100.0,
                 "standard deviation of a body's points; 2 to 2.5 reach the surface of a box",
                 "METHOD.md 5.4"});
    visit.Field("static_energy", self.static_energy,
                {"nats", 0.0, 100.0,
                 "affinity of the static scene: a landmark is a body's within sqrt(2 * this) "
                 "standard deviations of its centre",
                 "METHOD.md 5.4, not published"});
    visit.Field(
        "outlier_energy", self.outlier_energy,
        {"nats", 0.0, 100.0, "affinity of the outlier class", "METHOD.md 5.4, not published"});
    visit.Field("past_frames", self.past_frames,
                {"frames", 1, 200,
                 "how far back the motion term compares where a landmark was, or less where it is "
                 "younger; more shows slower motion, up to window.temporal - 1",
                 "paper, section 3.2: 5; at 30 Hz a slow body hardly moves in five frames"});
    visit.Field("motion_cap", self.motion_cap,
                {"1", 0.1, 1e6, "largest squared whitened error; larger trusts single errors more",
                 "METHOD.md 5.5"});
    visit.Field("neutral_motion", self.neutral_motion,
                {"nats", 0.0, 100.0,
                 "motion term of a class without a known motion: the mean of chi^2 / 2, 3 dof",
                 "METHOD.md 5.5"});
    visit.Field(
        "outlier_motion", self.outlier_motion,
        {"nats", 0.0, 100.0, "motion term of the outlier class: half of 9", "METHOD.md 5.5"});
    visit.Field("max_energy", self.max_energy,
                {"nats", 1.0, 1000.0, "largest energy of one term: none vetoes the others",
                 "METHOD.md 5.2"});
  }
};

}  // namespace cvo
