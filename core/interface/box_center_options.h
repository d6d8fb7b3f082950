// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

// Options for how accurately a box determines the centre of the body in it.
struct BoxCenterOptions {
  double edge_deviation = 0.05;
  double unseen_deviation = 0.3;
  double border_px = 3.0;
  double max_overlap = 0.05;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("edge_deviation", self.edge_deviation,
                {"sizes of the body", 1e-4, 10,
                 "standard deviation of the centre between two edges of a complete box",
                 "edges of detections jitter by some per cent of the box"});
    visit.Field(
        "unseen_deviation", self.unseen_deviation,
        {"sizes of the body", 1e-4, 10,
         "standard deviation of the centre along the line of sight, and across it where an edge of "
         "the box may not be the body's; the extent there depends on the body's shape",
         "half of a body as deep as it is wide, or less; not swept"});
    visit.Field(
        "border_px", self.border_px,
        {"px", 0, 1000, "box edges closer than this to the image border may be truncated by it",
         "detectors end boxes up to a few pixels before the border"});
    visit.Field("max_overlap", self.max_overlap,
                {"1", 0, 1,
                 "maximum fraction of a box that another box may overlap without being taken to "
                 "occlude the body",
                 "boxes of neighbours touch by the jitter of their edges"});
  }
};

}  // namespace cvo
