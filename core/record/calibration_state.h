// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/files/json/json_record.h"

namespace cvo::reports {

// The estimated calibration error: the coefficients of StereoCamera::right_field_px and their
// standard deviations.
struct CalibrationState {
  std::array<double, 6> right_field_px{};
  std::array<double, 6> sigma_px{};

  // Over the image.
  double Mean_px() const { return right_field_px[0]; }
  double MeanSigma_px() const { return sigma_px[0]; }

  CVO_FIELDS(right_field_px, sigma_px);
};

}  // namespace cvo::reports
