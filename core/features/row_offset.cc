// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/row_offset.h"

#include <Eigen/Cholesky>

namespace cvo {
namespace {

constexpr int kIterations = 8;
constexpr int kWideIterations = 3;
constexpr double kWideFactor = 4.0;
constexpr double kPriorSigma_px = 1.0;  // of each coefficient

}  // namespace

RowOffset::RowOffset(const std::vector<RowOffsetSample>& samples, double width_px, double height_px)
    : width_px_(width_px), height_px_(height_px) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  // Iteratively reweighted least squares with Geman-McClure weights. The first iterations use a
  // wider kernel, so that samples far from zero have an influence.
  for (int i = 0; i < kIterations; ++i) {
    const double width = i < kWideIterations ? kWideFactor : 1.0;
    Matrix6 H = Matrix6::Identity() / (kPriorSigma_px * kPriorSigma_px);
    Vector6 b = Vector6::Zero();
    for (const RowOffsetSample& sample : samples) {
      const Vector6 basis = Basis(sample.u_px, sample.v_px);
      const double error =
          (sample.offset_px - coefficients_.dot(basis)) / (width * sample.sigma_px);
      const double root = 1.0 / (1.0 + error * error);
      const double weight = root * root / (sample.sigma_px * sample.sigma_px);
      H.noalias() += weight * basis * basis.transpose();
      b.noalias() += weight * sample.offset_px * basis;
    }
    coefficients_ = H.ldlt().solve(b);
  }
}

RowOffset::Vector6 RowOffset::Basis(double u_px, double v_px) const {
  const double x = 2.0 * u_px / width_px_ - 1.0;
  const double y = 2.0 * v_px / height_px_ - 1.0;
  Vector6 basis;
  basis << 1.0, x, y, x * x, x * y, y * y;
  return basis;
}

}  // namespace cvo
