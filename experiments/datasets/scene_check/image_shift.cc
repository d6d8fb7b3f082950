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
    if (!Inside(source, p.u, p.v) || !Inside(target, u, v)) continue;
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

double SigmaOf(std::vector<float> residuals) {
  for (float& value : residuals) value = std::abs(value);
  return kMadToSigma * MedianOf(std::move(residuals));
}

}  // namespace

float MedianOf(std::vector<float> values) {
  if (values.empty()) return 0.0F;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

ImageShift EstimateShift(const cv::Mat& source, const cv::Mat& target,
                         const std::vector<PixelPrediction>& predictions) {
  constexpr int kIterations = 6;
  constexpr double kLeastCut_grey = 3.0;
  ImageShift result;
  Fit fit;
  // The first step only determines gain, offset and the size of the residuals.
  Step(source, target, predictions, 255.0, fit);
  fit.x.head<2>().setZero();
  for (int i = 0; i < kIterations; ++i) {
    Step(source, target, predictions, std::max(kLeastCut_grey, 3.0 * SigmaOf(fit.residuals)), fit);
  }
  result.pixels = static_cast<int>(fit.residuals.size());
  result.shift_px = fit.x.head<2>();
  return result;
}

}  // namespace cvo
