// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

// Options for re-identification: whether a new cluster continues a lost one, and how its object
// frame is aligned with that of the lost cluster.
struct IdentityOptions {
  double gate = 2.0;
  double center_deviation = 0.3;
  double max_spread_m = 1.0;
  double prediction_deviation = 0.3;
  double min_lead = 0.25;
  double size_factor = 1.7;
  int align_boxes = 15;
  int align_interval = 5;
  double point_deviation = 0.08;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("gate", self.gate,
                {"standard deviations", 0, 100,
                 "gate, in standard deviations, for a new cluster to inherit the id of a lost "
                 "cluster of its class; the lost cluster must explain its position and size at "
                 "least as well as one predicted to within identity.max_spread_m does at this many "
                 "standard deviations; larger keeps more identities and confuses more",
                 "chosen from 1.5 ... 3 on the rooms, streets and the crowd"});
    visit.Field("center_deviation", self.center_deviation,
                {"sizes of the body", 1e-3, 10,
                 "standard deviation between the centres of one body estimated from its boxes "
                 "before and after it was lost",
                 "set by hand on the rendered rooms, not swept"});
    visit.Field("max_spread_m", self.max_spread_m,
                {"m", 1e-3, 1000,
                 "maximum standard deviation of a lost cluster's predicted position: bodies turn "
                 "back, and rooms have walls",
                 "the free space of the rendered rooms, not swept"});
    visit.Field(
        "prediction_deviation", self.prediction_deviation,
        {"deviations of the motion", 1e-3, 1e6,
         "standard deviation of a re-found cluster's position about the position that its motion "
         "before and after the loss predicts; larger trusts the boxes, smaller the motion",
         "chosen from 0.3, 0.6 and 1 on development rooms, crowds, benches and streets, "
         "where little but the object ATE of benches changes"});
    visit.Field("min_lead", self.min_lead,
                {"nats", 0, 100,
                 "minimum log-likelihood margin over the second-best candidate; with larger "
                 "values, doubtful clusters keep a new id",
                 "set by hand on the rooms and the crowd, not swept"});
    visit.Field("size_factor", self.size_factor,
                {"1", 1.01, 100,
                 "standard deviation of a body's size between boxes, as a factor: a turning body "
                 "shows another side",
                 "set by hand on the rendered rooms, not swept"});
    visit.Field("align_boxes", self.align_boxes,
                {"boxes", 1, 10000,
                 "number of boxes up to which a re-found cluster's frame is re-estimated in every "
                 "frame, unless landmarks aligned it earlier",
                 "half a second at 30 Hz, not swept"});
    visit.Field(
        "align_interval", self.align_interval,
        {"frames", 1, 1000,
         "frames between searches for landmarks to refine a frame that was aligned by centres",
         "bounds time"});
    visit.Field("point_deviation", self.point_deviation,
                {"sizes of the body", 1e-4, 1,
                 "maximum distance at which landmarks of the old and the new object frame are "
                 "taken for the same point",
                 "set by hand on the rendered rooms, not swept"});
  }
};

}  // namespace cvo
