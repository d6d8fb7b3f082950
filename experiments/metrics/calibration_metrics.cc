// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/calibration_metrics.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace cvo {
namespace {

// Mean squares over the image of the terms of FieldBasis, whose products have mean zero.
const Vector6d kMeanSquares{{1.0, 1.0 / 3.0, 1.0 / 3.0, 4.0 / 45.0, 1.0 / 9.0, 4.0 / 45.0}};

}  // namespace

std::vector<Metric> EvaluateCalibration(const Vector6d& true_field_px,
                                        const CalibrationReport& estimate) {
  if (!estimate.IsEstimated()) return {};
  const Vector6d error = estimate.right_field_px - true_field_px;
  const double claimed = error.dot(estimate.Covariance_px2().llt().solve(error));
  std::vector<Metric> metrics = {
      MakeMetric({reports::MetricId::kCalibrationError},
                 std::sqrt(error.cwiseAbs2().dot(kMeanSquares)), 1),
      MakeMetric({reports::MetricId::kCalibrationNees}, claimed / 6.0, 1)};
  for (Metric& metric : metrics) {
    metric.contract.subject = reports::Subject::kStereo;
    metric.contract.truth = reports::TruthSource::kScene;
    metric.left_out = "nothing";
  }
  return metrics;
}

}  // namespace cvo
