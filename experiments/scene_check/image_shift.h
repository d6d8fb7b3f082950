// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace cvo {

// A pixel of one image and the predicted position of its point in another image.
struct PixelPrediction {
  int u = 0;
  int v = 0;
  double target_u = 0.0;
  double target_v = 0.0;
};

// The common offset of all predictions: target(predicted + shift) = gain source + offset.
struct ImageShift {
  Eigen::Vector2d shift_px = Eigen::Vector2d::Zero();
  // Inverse covariance of the shift for residuals of one grey level, with gain and offset
  // marginalised.
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  double residual_sigma = 0.0;   // grey levels, robust estimate
  int pixels = 0;                // number of pixels compared
  std::vector<float> residuals;  // |target(predicted) - gain source - offset|, ascending

  double MaxSigma_px() const;  // of the shift in its worst direction; infinite without texture
};

// Estimates the shift by Gauss-Newton on the intensities of CV_8UC1 images. Leaves out residuals
// beyond three sigmas (or three grey levels, if that is more) and predictions nearer than three
// pixels to the border of either image.
ImageShift EstimateShift(const cv::Mat& source, const cv::Mat& target,
                         const std::vector<PixelPrediction>& predictions);

// Combines the shifts of many images, weighted by their information.
ImageShift PoolShifts(const std::vector<ImageShift>& shifts);

// Estimates the standard deviation of an image's noise in grey levels, from its flattest parts.
double EstimateNoise(const cv::Mat& image);

}  // namespace cvo
