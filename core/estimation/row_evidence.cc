// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/row_evidence.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace cvo {
namespace {

// Coefficients of a polynomial over X/Z, Y/Z.
enum Monomial { kX, kY, kXX, kXY, kYY };

// Maps coefficients in FieldBasis to those of the monomials, without the constant.
Eigen::Matrix<double, 5, 6> RayCoefficients(const StereoCamera& camera) {
  const FieldBasis center = camera.BasisAt(camera.cx, camera.cy);
  const double x0 = center.value[1];
  const double y0 = center.value[2];
  const double a = camera.fx * center.by_u[1];  // dx / d(X/Z)
  const double b = camera.fy * center.by_v[2];
  Eigen::Matrix<double, 5, 6> T = Eigen::Matrix<double, 5, 6>::Zero();
  T.row(kX) << 0.0, a, 0.0, 2.0 * a * x0, a * y0, 0.0;
  T.row(kY) << 0.0, 0.0, b, 0.0, b * x0, 2.0 * b * y0;
  T(kXX, 3) = a * a;
  T(kXY, 4) = a * b;
  T(kYY, 5) = b * b;
  return T;
}

}  // namespace

std::vector<RowOffset> RowOffsets(const std::vector<StereoFeature>& features, double scale_factor) {
  std::vector<RowOffset> offsets;
  offsets.reserve(features.size());
  for (const StereoFeature& feature : features) {
    if (std::isnan(feature.row_offset_px)) continue;
    offsets.push_back({feature.z_px[0], feature.z_px[1], feature.z_px[0] - feature.z_px[2],
                       feature.row_offset_px, RowSigma(std::pow(scale_factor, feature.octave))});
  }
  return offsets;
}

void AppendRowEvidence(const RowField& rows, const StereoCamera& camera, double deviation_px,
                       WindowPrior& prior) {
  const Eigen::Matrix<double, 5, 6> T = RayCoefficients(camera);
  using Relations = Eigen::Matrix<double, 4, 6>;
  Relations of_columns;
  of_columns << T.row(kX), T.row(kY), T.row(kXX) - T.row(kYY), T.row(kXY);
  Relations of_rows;
  of_rows << T.row(kY), -T.row(kX), T.row(kXY), T.row(kYY) - T.row(kXX);
  Matrix6d covariance = rows.Covariance().topLeftCorner<6, 6>();
  covariance.diagonal().array() += deviation_px * deviation_px;
  const Eigen::LLT<Eigen::Matrix4d> root((of_rows * covariance * of_rows.transpose()).eval());
  const Eigen::Vector4d difference =
      of_columns * prior.right_field_point_px - of_rows * rows.coefficients().head<6>();
  const Eigen::Index n = prior.r0.size();
  prior.J0.conservativeResize(n + 4, Eigen::NoChange);
  prior.J0.bottomRows<4>().setZero();
  prior.J0.bottomRightCorner<4, 6>() = root.matrixL().solve(of_columns);
  prior.r0.conservativeResize(n + 4);
  prior.r0.tail<4>() = root.matrixL().solve(difference);
}

}  // namespace cvo
