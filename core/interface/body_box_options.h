// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "core/base/options.h"

namespace cvo {

// The boxes that are reported of bodies (METHOD.md 10.4); the estimator itself does not use them.
struct BodyBoxOptions {
  double quantile = 0.02;
  double footprint_ratio = 1.2;
  double car_length_m = 3.883;
  double car_width_m = 1.627;
  double car_height_m = 1.516;
  double heading_deviations = 1.0;
  int max_views = 30;

  // Length, height and width of bodies of the class; 0 where their landmarks have to tell.
  Eigen::Vector3d SizeOf(std::string_view category) const {
    if (category != "Car") return Eigen::Vector3d::Zero();
    return {car_length_m, car_height_m, car_width_m};
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
                 "maximum ratio of a side of the footprint of such a body to that of the square "
                 "that looks as wide as its detections: what lies along the line of sight is "
                 "hardly seen, and landmarks behind the body may be taken for its own",
                 "METHOD.md 10.4"});
    constexpr const char* kMeanCar = "mean of the rows of class Car in KITTI tracking's label_02";
    visit.Field("car_length_m", self.car_length_m,
                {"m", 0.0, 30.0, "length of every car; 0: from its landmarks", kMeanCar});
    visit.Field("car_width_m", self.car_width_m,
                {"m", 0.0, 30.0, "width of every car; 0: from its landmarks", kMeanCar});
    visit.Field("car_height_m", self.car_height_m,
                {"m", 0.0, 30.0, "height of every car; 0: from its landmarks", kMeanCar});
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
