// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/row_field.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace cvo {
namespace {

constexpr int kIterations = 2;
constexpr int kFirstIterations = 8;
constexpr int kWideIterations = 3;
constexpr double kWideFactor = 4.0;
constexpr double kPriorSigma_px = 1.0;     // of each coefficient of the polynomial
constexpr double kPriorSigmaSlope = 0.01;  // px per px of disparity: the slope of the baseline
constexpr double kCornerSigma_px = 0.4;

RowField::Vector Basis(const StereoCamera& camera, double u_px, double v_px, double disparity_px) {
  RowField::Vector basis;
  basis << camera.BasisAt(u_px, v_px).value, disparity_px;
  return basis;
}

}  // namespace

double RowSigma(double scale) { return kCornerSigma_px * scale; }

RowField::RowField() {
  information_ = Matrix::Identity() / (kPriorSigma_px * kPriorSigma_px);
  information_(6, 6) = 1.0 / (kPriorSigmaSlope * kPriorSigmaSlope);
}

void RowField::Add(const std::vector<RowOffset>& samples, const StereoCamera& camera) {
  std::vector<Vector> bases;
  bases.reserve(samples.size());
  for (const RowOffset& sample : samples) {
    bases.push_back(Basis(camera, sample.u_px, sample.v_px, sample.disparity_px));
  }
  // Iteratively reweighted least squares with Geman-McClure weights. The first iterations of the
  // first fit use a wider kernel, so that samples far from zero have an influence.
  Matrix information;
  Vector weighted;
  const int iterations = is_empty_ ? kFirstIterations : kIterations;
  for (int i = 0; i < iterations; ++i) {
    const double width = is_empty_ && i < kWideIterations ? kWideFactor : 1.0;
    information = information_;
    weighted = weighted_;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const RowOffset& sample = samples[k];
      const double error =
          (sample.offset_px - coefficients_.dot(bases[k])) / (width * sample.sigma_px);
      const double root = 1.0 / (1.0 + error * error);
      const double weight = root * root / (sample.sigma_px * sample.sigma_px);
      information.noalias() += weight * bases[k] * bases[k].transpose();
      weighted.noalias() += weight * sample.offset_px * bases[k];
    }
    coefficients_ = information.ldlt().solve(weighted);
  }
  information_ = information;
  weighted_ = weighted;
  is_empty_ = is_empty_ && samples.empty();
}

double RowField::At(const StereoCamera& camera, double u_px, double v_px,
                    double disparity_px) const {
  return coefficients_.dot(Basis(camera, u_px, v_px, disparity_px));
}

}  // namespace cvo
