// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace cvo {

// A pixel of one image and where its point should be in another one.
struct PixelPrediction {
  int u = 0;
  int v = 0;
  double target_u = 0.0;
  double target_v = 0.0;
};

// How far off the predictions are as a whole: target(predicted + shift) = gain source + offset.
struct ImageShift {
  Eigen::Vector2d shift_px = Eigen::Vector2d::Zero();
  // Inverse covariance of the shift for residuals of one grey level, gain and offset taken out.
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  double residual_sigma = 0.0;   // grey levels, robust
  int pixels = 0;                // that were compared
  std::vector<float> residuals;  // |target(predicted) - gain source - offset|, ascending

  double MaxSigma_px() const;  // of the shift in its worst direction; infinite without texture
};

// Gauss-Newton on intensities of CV_8UC1 images, residuals beyond three sigmas left out.
// Predictions nearer than three pixels to the border of either image are left out.
ImageShift EstimateShift(const cv::Mat& source, const cv::Mat& target,
                         const std::vector<PixelPrediction>& predictions);

// The shift that many images together say, weighted by what each knows.
ImageShift PoolShifts(const std::vector<ImageShift>& shifts);

// Standard deviation of an image's noise in grey levels, from its flattest parts.
double EstimateNoise(const cv::Mat& image);

}  // namespace cvo
