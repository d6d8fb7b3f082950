// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>

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

// Size of the bodies of a class. A size of 0 is estimated from their landmarks.
struct ClassSize {
  double length_m = 0.0;
  double width_m = 0.0;
  double height_m = 0.0;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    constexpr const char* kSource =
        "Car: mean of its rows in KITTI tracking's label_02; the others: means of KITTI's object "
        "labels as in Frustum PointNets (Qi et al. 2018)";
    visit.Field(
        "length_m", self.length_m,
        {"m", 0.0, 100.0, "length of every body of the class; 0: from its landmarks", kSource});
    visit.Field(
        "width_m", self.width_m,
        {"m", 0.0, 100.0, "width of every body of the class; 0: from its landmarks", kSource});
    visit.Field(
        "height_m", self.height_m,
        {"m", 0.0, 100.0, "height of every body of the class; 0: from its landmarks", kSource});
  }
};

// Whether bodies of the class are balls.
inline bool IsRound(std::string_view category) { return category == "Ball"; }

// Options of the boxes reported for bodies (METHOD.md 10.4). The estimator itself does not use
// these boxes.
struct BodyBoxOptions {
  double quantile = 0.02;
  double footprint_ratio = 1.2;
  double heading_deviations = 1.0;
  int max_views = 30;

  ClassSize car = {3.883, 1.627, 1.516};
  ClassSize van = {5.068, 1.901, 2.205};
  ClassSize truck = {10.136, 2.585, 3.252};
  ClassSize tram = {16.172, 2.532, 3.531};
  ClassSize pedestrian = {0.844, 0.661, 1.763};
  ClassSize person_sitting = {0.801, 0.598, 1.275};
  ClassSize cyclist = {1.763, 0.597, 1.737};

  // Returns the length, height and width of the bodies of a class, m, by its name in KITTI. A size
  // of 0 is estimated from their landmarks.
  Eigen::Vector3d SizeOf(std::string_view category) const {
    const ClassSize size = category == "Car"              ? car
                           : category == "Van"            ? van
                           : category == "Truck"          ? truck
                           : category == "Tram"           ? tram
                           : category == "Pedestrian"     ? pedestrian
                           : category == "Person_sitting" ? person_sitting
                           : category == "Cyclist"        ? cyclist
                                                          : ClassSize();
    return {size.length_m, size.height_m, size.width_m};
  }

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("quantile", self.quantile,
                {"1", 0.0, 0.49,
                 "the side of a body without a class size reaches from this quantile of its "
                 "landmarks to one minus it; larger rejects more outliers and cuts more off",
                 "METHOD.md 10.4"});
    visit.Field("footprint_ratio", self.footprint_ratio,
                {"1", 1.0, 1000.0,
                 "for a body without a class size: maximum factor between a side of its footprint "
                 "and the square that appears as wide as its detections; extent along the line of "
                 "sight is poorly observed, and landmarks behind the body may be taken for its own",
                 "METHOD.md 10.4"});
    visit.Group("car", self.car);
    visit.Group("van", self.van);
    visit.Group("truck", self.truck);
    visit.Group("tram", self.tram);
    visit.Group("pedestrian", self.pedestrian);
    visit.Group("person_sitting", self.person_sitting);
    visit.Group("cyclist", self.cyclist);
    visit.Field("heading_deviations", self.heading_deviations,
                {"standard deviations", 0.0, 1e9,
                 "a body that moved by more than this many deviations of one triangulated point "
                 "heads along its motion; 1e9: never, it keeps the heading of its birth, as in the "
                 "paper",
                 "METHOD.md 10.4"});
    visit.Field("max_views", self.max_views,
                {"frames", 1, 10000,
                 "maximum weight of past views in the centre of a box, in frames; larger is "
                 "steadier and corrects errors more slowly",
                 "one to three seconds"});
  }
};

}  // namespace cvo
