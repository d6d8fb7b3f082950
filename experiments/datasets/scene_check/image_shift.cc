// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "experiments/datasets/scene_check/checks.h"

namespace cvo {

namespace {

constexpr double kMadToSigma = 1.4826;
constexpr int kBorder_px = 3;

struct Sample {
  double value = 0.0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
};

// Catmull-Rom weights of the four neighbours, and their derivatives.
void CubicWeights(double t, std::array<double, 4>& w, std::array<double, 4>& dw) {
  const double t2 = t * t, t3 = t2 * t;
  w = {0.5 * (-t3 + 2 * t2 - t), 0.5 * (3 * t3 - 5 * t2 + 2), 0.5 * (-3 * t3 + 4 * t2 + t),
       0.5 * (t3 - t2)};
  dw = {0.5 * (-3 * t2 + 4 * t - 1), 0.5 * (9 * t2 - 10 * t), 0.5 * (-9 * t2 + 8 * t + 1),
        0.5 * (3 * t2 - 2 * t)};
}

Sample SampleAt(const cv::Mat& image, double u, double v) {
  const int u0 = static_cast<int>(std::floor(u)), v0 = static_cast<int>(std::floor(v));
  std::array<double, 4> wu, dwu, wv, dwv;
  CubicWeights(u - u0, wu, dwu);
  CubicWeights(v - v0, wv, dwv);
  Sample sample;
  for (int j = 0; j < 4; ++j) {
    const unsigned char* row = image.ptr(v0 - 1 + j) + u0 - 1;
    double value = 0.0, du = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      value += wu[i] * row[i];
      du += dwu[i] * row[i];
    }
    const auto k = static_cast<std::size_t>(j);
    sample.value += wv[k] * value;
    sample.gradient += Eigen::Vector2d(wv[k] * du, dwv[k] * value);
  }
  return sample;
}

Eigen::Vector2d CentralGradient(const cv::Mat& image, int u, int v) {
  return {0.5 * (image.at<unsigned char>(v, u + 1) - image.at<unsigned char>(v, u - 1)),
          0.5 * (image.at<unsigned char>(v + 1, u) - image.at<unsigned char>(v - 1, u))};
}

bool Inside(const cv::Mat& image, double u, double v) {
  return u >= kBorder_px && v >= kBorder_px && u < image.cols - 1 - kBorder_px &&
         v < image.rows - 1 - kBorder_px;
}

// The unknowns x are the shift in u and v, gain - 1, and offset.
struct Fit {
  Eigen::Vector4d x = Eigen::Vector4d::Zero();
  Eigen::Matrix4d H = Eigen::Matrix4d::Zero();
  double sigma = 0.0;
  std::vector<float> residuals;  // signed, at x before the last step
};

// Performs one Gauss-Newton step from `fit.x`, using the residuals within `cut`.
void Step(const cv::Mat& source, const cv::Mat& target,
          const std::vector<PixelPrediction>& predictions, double cut, Fit& fit) {
  fit.H.setZero();
  fit.residuals.clear();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  for (const PixelPrediction& p : predictions) {
    const double u = p.target_u + fit.x[0], v = p.target_v + fit.x[1];
    if (!Inside(target, u, v)) continue;
    const Sample sample = SampleAt(target, u, v);
    const double value = source.at<unsigned char>(p.v, p.u);
    const double residual = sample.value - (1.0 + fit.x[2]) * value - fit.x[3];
    fit.residuals.push_back(static_cast<float>(residual));
    if (std::abs(residual) > cut) continue;
    // The mean gradient of both images: the noise in the gradient of only one would bias the shift.
    const Eigen::Vector2d gradient =
        0.5 * (sample.gradient + (1.0 + fit.x[2]) * CentralGradient(source, p.u, p.v));
    const Eigen::Vector4d J(gradient[0], gradient[1], -value, -1.0);
    fit.H.noalias() += J * J.transpose();
    b.noalias() -= J * residual;
  }
  if (fit.residuals.size() < 16) return;
  const Eigen::LDLT<Eigen::Matrix4d> factors(fit.H);
  if (factors.info() != Eigen::Success || !(factors.rcond() > 1e-14)) return;
  const Eigen::Vector4d step = factors.solve(b);
  constexpr double kLongestStep_px = 1.0;
  const double length = step.head<2>().norm();
  fit.x += step * std::min(1.0, kLongestStep_px / std::max(length, 1e-12));
}

double SigmaOf(const std::vector<float>& residuals) {
  std::vector<float> magnitudes = residuals;
  for (float& value : magnitudes) value = std::abs(value);
  return kMadToSigma * MedianOf(magnitudes);
}

std::vector<PixelPrediction> Usable(const cv::Mat& source, const cv::Mat& target,
                                    const std::vector<PixelPrediction>& predictions) {
  std::vector<PixelPrediction> usable;
  for (const PixelPrediction& p : predictions) {
    if (Inside(source, p.u, p.v) && Inside(target, p.target_u, p.target_v)) usable.push_back(p);
  }
  return usable;
}

}  // namespace

float MedianOf(std::vector<float> values) {
  if (values.empty()) return 0.0F;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double ImageShift::MaxSigma_px() const {
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(information).eigenvalues()[0];
  return least > 0.0 ? residual_sigma / std::sqrt(least) : std::numeric_limits<double>::infinity();
}

ImageShift EstimateShift(const cv::Mat& source, const cv::Mat& target,
                         const std::vector<PixelPrediction>& predictions) {
  constexpr int kIterations = 6;
  constexpr double kLeastCut_grey = 3.0;
  const std::vector<PixelPrediction> usable = Usable(source, target, predictions);
  ImageShift result;
  result.pixels = static_cast<int>(usable.size());
  Fit fit;
  // The first step only determines gain, offset and the size of the residuals.
  Step(source, target, usable, 255.0, fit);
  fit.x.head<2>().setZero();
  for (int i = 0; i < kIterations; ++i) {
    const double sigma = SigmaOf(fit.residuals);
    Step(source, target, usable, std::max(kLeastCut_grey, 3.0 * sigma), fit);
    if (i > 0) continue;
    for (const float residual : fit.residuals) result.residuals.push_back(std::abs(residual));
    std::sort(result.residuals.begin(), result.residuals.end());
  }
  result.shift_px = fit.x.head<2>();
  result.residual_sigma = SigmaOf(fit.residuals);
  const Eigen::Matrix2d rest = fit.H.bottomRightCorner<2, 2>();
  if (result.pixels > 0 && rest.determinant() > 0.0) {
    result.information = fit.H.topLeftCorner<2, 2>() - fit.H.topRightCorner<2, 2>() *
                                                           rest.inverse() *
                                                           fit.H.bottomLeftCorner<2, 2>();
  }
  return result;
}

ImageShift PoolShifts(const std::vector<ImageShift>& shifts) {
  ImageShift pooled;
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  double variance = 0.0;
  for (const ImageShift& shift : shifts) {
    pooled.information += shift.information;
    weighted += shift.information * shift.shift_px;
    pooled.pixels += shift.pixels;
    variance += shift.pixels * shift.residual_sigma * shift.residual_sigma;
  }
  if (pooled.information.determinant() > 0.0) {
    pooled.shift_px = pooled.information.ldlt().solve(weighted);
  }
  if (pooled.pixels > 0) pooled.residual_sigma = std::sqrt(variance / pooled.pixels);
  return pooled;
}

double EstimateNoise(const cv::Mat& image) {
  // The difference of two Laplacians does not respond to planes, and the flattest tenth of the
  // blocks has the least texture (Immerkaer 1996, applied to blocks).
  constexpr int kBlock_px = 16;
  std::vector<float> blocks;
  for (int v0 = 1; v0 + kBlock_px < image.rows; v0 += kBlock_px) {
    for (int u0 = 1; u0 + kBlock_px < image.cols; u0 += kBlock_px) {
      double squares = 0.0;
      for (int v = v0; v < v0 + kBlock_px; ++v) {
        const unsigned char *a = image.ptr(v - 1), *b = image.ptr(v), *c = image.ptr(v + 1);
        for (int u = u0; u < u0 + kBlock_px; ++u) {
          const int laplacian = a[u - 1] - 2 * a[u] + a[u + 1] - 2 * b[u - 1] + 4 * b[u] -
                                2 * b[u + 1] + c[u - 1] - 2 * c[u] + c[u + 1];
          squares += laplacian * laplacian;
        }
      }
      blocks.push_back(static_cast<float>(std::sqrt(squares / (36.0 * kBlock_px * kBlock_px))));
    }
  }
  if (blocks.empty()) return 0.0;
  const auto tenth = blocks.begin() + static_cast<std::ptrdiff_t>(blocks.size() / 10);
  std::nth_element(blocks.begin(), tenth, blocks.end());
  return *tenth;
}

}  // namespace cvo
