// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/interface/frame.h"
#include "experiments/metrics/metric.h"

namespace cvo {

// Measures self-calibration against the true coefficients of StereoCamera::right_field_px:
// calibration_error and calibration_nees. Empty if it was not estimated.
std::vector<Metric> EvaluateCalibration(const Vector6d& true_field_px,
                                        const CalibrationReport& estimate);

}  // namespace cvo
