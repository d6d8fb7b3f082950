// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "experiments/metrics/kitti_ap/ap_protocol.h"

namespace cvo {

// Labels and detections of one image. A detection without a score ranks as one of score 1.
struct ApFrame {
  std::vector<ObjectBox> labels;
  std::vector<ObjectBox> detections;
};

inline constexpr std::size_t kRecallSlots = 41;

struct AveragePrecision {
  ApLevel level = ApLevel::kEasy;
  double ap11 = 0.0;  // mean over recall 0, 0.1, ..., 1; in [0, 1]
  double ap40 = 0.0;  // mean over recall 1/40, 2/40, ..., 1: the benchmark's since October 2019
  int valid_labels = 0;
  // At recall i/40: the highest precision there or at higher recall, 0 beyond the highest recall.
  std::array<double, kRecallSlots> precision = {};

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("level", self.level);
    archive.Field("ap11", self.ap11);
    archive.Field("ap40", self.ap40);
    archive.Field("valid_labels", self.valid_labels);
    archive.Field("precision", self.precision);
  }
};

// Of each level. Frames without detections count: their labels are missed.
std::array<AveragePrecision, 3> EvaluateAp(const std::vector<ApFrame>& frames,
                                           const ApProtocol& protocol);

}  // namespace cvo
