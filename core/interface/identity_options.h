// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

// As who a found cluster goes on, and how its frame is aligned with the former one.
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
                 "threshold for a new cluster to inherit the id of a lost one of its class: the "
                 "lost one must explain its position and size at least as well as a cluster "
                 "expected within max_spread_m does at this many standard deviations; larger keeps "
                 "more identities and confuses more",
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
    visit.Field("prediction_deviation", self.prediction_deviation,
                {"deviations of the motion", 1e-3, 1e6,
                 "standard deviation of a found cluster's place around the one that its motions "
                 "before and after tell: larger trusts the boxes, smaller the motions",
                 "chosen from 0.3, 0.6 and 1 on development rooms, crowds, benches and streets, "
                 "where little but the object ATE of benches changes"});
    visit.Field("min_lead", self.min_lead,
                {"nats", 0, 100,
                 "minimum margin by which the next candidate must be less likely; with larger "
                 "values, doubtful identities stay new",
                 "set by hand on the rooms and the crowd, not swept"});
    visit.Field("size_factor", self.size_factor,
                {"1", 1.01, 100,
                 "standard deviation of a body's size between boxes, as a factor: a turning body "
                 "shows another side",
                 "set by hand on the rendered rooms, not swept"});
    visit.Field(
        "align_boxes", self.align_boxes,
        {"boxes", 1, 10000,
         "number of boxes up to which a found cluster's frame is placed anew in every frame, "
         "unless landmarks aligned it earlier",
         "half a second at 30 Hz, not swept"});
    visit.Field(
        "align_interval", self.align_interval,
        {"frames", 1, 1000,
         "frames between searches for landmarks to refine a frame that was aligned by centres",
         "bounds time"});
    visit.Field("point_deviation", self.point_deviation,
                {"sizes of the body", 1e-4, 1,
                 "landmarks of the former and the new frame are the same point within this "
                 "distance",
                 "set by hand on the rendered rooms, not swept"});
  }
};

}  // namespace cvo
