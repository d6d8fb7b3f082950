// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/sensor/sensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/rng.h"
#include "synth/sensor/quick_normal.h"

namespace cvo::synth {
namespace {

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
};

Moments MomentsOf(const cv::Mat& image) {
  cv::Scalar mean, std;
  cv::meanStdDev(image, mean, std);
  return {mean[0], std[0] * std[0]};
}

cv::Mat Flat(int grey) { return {480, 640, CV_8UC1, cv::Scalar(grey)}; }

SensorOptions AllOff() { return NoiselessSensor({}); }

bool Same(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0.0; }

constexpr double kRounding = 1.0 / 12.0;  // variance due to rounding to integers

TEST(NormalQuantiles, HaveUnitVarianceAndNormalShape) {
  const std::vector<float>& quantiles = NormalQuantiles();
  ASSERT_EQ(quantiles.size(), 65536U);
  double sum = 0.0, square = 0.0, fourth = 0.0;
  for (const double q : quantiles) {
    sum += q;
    square += q * q;
    fourth += q * q * q * q;
  }
  EXPECT_NEAR(sum, 0.0, 1e-6);
  EXPECT_NEAR(square / 65536.0, 1.0, 1e-5);
  EXPECT_NEAR(fourth / 65536.0, 3.0, 0.01);
  EXPECT_NEAR(quantiles[55138], 1.0, 1e-3);  // quantile 0.84134 of 65536
}

TEST(ApplySensor, WithoutEffectsNothingChanges) {
  const cv::Mat clean = Flat(77);
  EXPECT_TRUE(HasNoEffect(AllOff()));
  EXPECT_TRUE(Same(ApplySensor(clean, AllOff(), 1, 1, 5), clean));
  EXPECT_FALSE(HasNoEffect(SensorOptions()));
}

TEST(ApplySensor, ReadNoiseHasItsVariance) {
  SensorOptions options = AllOff();
  options.read_noise = 3.0;
  const Moments moments = MomentsOf(ApplySensor(Flat(100), options, 0, 0, 0));
  EXPECT_NEAR(moments.mean, 100.0, 0.03);
  EXPECT_NEAR(moments.variance, 9.0 + kRounding, 0.1);
}

// Grey level g corresponds to g / 255 of the full well. The variance in electrons equals their
// number.
TEST(ApplySensor, ShotNoiseVarianceIsProportionalToSignal) {
  SensorOptions options = AllOff();
  options.full_well = 2000.0;
  for (const int grey : {20, 80, 160}) {
    const Moments moments = MomentsOf(ApplySensor(Flat(grey), options, 0, 0, 0));
    EXPECT_NEAR(moments.mean, grey, 0.05);
    EXPECT_NEAR(moments.variance / (grey * 255.0 / 2000.0 + kRounding), 1.0, 0.02) << grey;
  }
}

TEST(ApplySensor, AppliesGainExposureAndBlackLevel) {
  SensorOptions options = AllOff();
  options.gain = 1.5;
  options.exposure_difference = 0.1;
  options.black_level = 4.0;
  EXPECT_TRUE(Same(ApplySensor(Flat(60), options, 0, 0, 0), Flat(94)));
  EXPECT_TRUE(Same(ApplySensor(Flat(60), options, 0, 1, 0), Flat(103)));
}

TEST(ApplySensor, VignettingDarkensTheCorners) {
  SensorOptions options = AllOff();
  options.vignetting = 0.2;
  const cv::Mat image = ApplySensor(Flat(200), options, 0, 0, 0);
  EXPECT_EQ(image.at<unsigned char>(0, 0), 160);
  EXPECT_EQ(image.at<unsigned char>(479, 639), 160);
  EXPECT_EQ(image.at<unsigned char>(240, 320), 200);
  EXPECT_GT(image.at<unsigned char>(240, 0), 160);
  EXPECT_LT(image.at<unsigned char>(240, 0), 200);
}

TEST(ApplySensor, ClampsAtBlackAndWhite) {
  SensorOptions options = AllOff();
  options.read_noise = 20.0;
  double low = 0.0, high = 0.0;
  cv::minMaxLoc(ApplySensor(Flat(250), options, 0, 0, 0), &low, &high);
  EXPECT_EQ(high, 255.0);
  cv::minMaxLoc(ApplySensor(Flat(3), options, 0, 0, 0), &low, &high);
  EXPECT_EQ(low, 0.0);
}

TEST(ApplySensor, NoiseDependsOnSeedCameraAndFrame) {
  const SensorOptions options;
  const cv::Mat clean = Flat(120);
  const cv::Mat image = ApplySensor(clean, options, 0, 0, 3);
  EXPECT_TRUE(Same(image, ApplySensor(clean, options, 0, 0, 3)));
  EXPECT_FALSE(Same(image, ApplySensor(clean, options, 1, 0, 3)));
  EXPECT_FALSE(Same(image, ApplySensor(clean, options, 0, 1, 3)));
  EXPECT_FALSE(Same(image, ApplySensor(clean, options, 0, 0, 4)));
}

}  // namespace
}  // namespace cvo::synth
