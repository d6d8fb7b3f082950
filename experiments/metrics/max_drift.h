// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "experiments/metrics/pose_errors.h"
#include "reports/results/metric_catalogue.h"

namespace cvo {

// How Oxford Multimotion's maximum drift is taken: sources register the frame of the estimate with
// that of the truth in three ways, before they take the largest error.
enum class DriftProtocol {
  kAllPoses,      // ClusterVO: one transform on the right of all poses; each angle by itself
  kAllMotions,    // the data set's tool: one transform of the motions since the first frame; the
                  // three angles of the frame where they are largest together
  kFirstMotions,  // MVO 2018: the same transform from the first 25 frames alone
};

constexpr std::array kDriftProtocols = {DriftProtocol::kAllPoses, DriftProtocol::kAllMotions,
                                        DriftProtocol::kFirstMotions};

// Angles are absolute values.
struct MaxDrift {
  double translation_m = 0.0;
  Eigen::Vector3d roll_pitch_yaw_rad = Eigen::Vector3d::Zero();

  std::array<double, 4> Values() const {
    return {translation_m, roll_pitch_yaw_rad.x(), roll_pitch_yaw_rad.y(), roll_pitch_yaw_rad.z()};
  }
};

// The metric of value `index` by a protocol: the catalogue has them in this order, after `first`.
constexpr reports::MetricId DriftMetric(reports::MetricId first, DriftProtocol protocol,
                                        std::size_t index) {
  return static_cast<reports::MetricId>(static_cast<std::size_t>(first) +
                                        4 * static_cast<std::size_t>(protocol) + index);
}

// With the first common pose of either as its world.
CommonPoses FromFirst(const CommonPoses& poses);

// Of poses in one world. Empty with fewer than two.
[[nodiscard]] std::optional<MaxDrift> MeasureMaxDrift(const CommonPoses& poses,
                                                      DriftProtocol protocol);

}  // namespace cvo
