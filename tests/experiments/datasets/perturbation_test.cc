// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <string>

#include "experiments/datasets/sequence.h"
#include "tests/support/error_message.h"

namespace cvo {
namespace {

using testing::HasSubstr;

// Returns ten frames, of which frame i has the images "l<i>" and "r<i>".
Sequence TenFrames(const Json& perturbation, std::uint64_t seed = 1) {
  Sequence sequence;
  sequence.first_frame = 5;
  sequence.camera.fx = 700.0;
  sequence.camera.fy = 700.0;
  sequence.camera.baseline_m = 0.5;
  for (int i = 0; i < 10; ++i) {
    sequence.images.push_back({"l" + std::to_string(i), "r" + std::to_string(i)});
  }
  Perturbation parsed = ParsePerturbation(perturbation, "s");
  parsed.seed = seed;
  PerturbSequence(parsed, sequence);
  return sequence;
}

cv::Mat Ramp() {
  cv::Mat grey(40, 60, CV_8UC1);
  for (int v = 0; v < grey.rows; ++v) {
    for (int u = 0; u < grey.cols; ++u) {
      grey.at<unsigned char>(v, u) = static_cast<unsigned char>(3 * v + 2 * u);
    }
  }
  return grey;
}

cv::Mat Perturbed(const Json& perturbation, int side = 0, std::size_t index = 2,
                  std::uint64_t seed = 1) {
  cv::Mat grey = Ramp();
  PerturbImage(TenFrames(perturbation, seed), index, side, grey);
  return grey;
}

double Distance(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

TEST(Perturbation, TheDefaultsChangeNothing) {
  EXPECT_EQ(PerturbationToJson(ParsePerturbation(Json::object(), "s")), Json::object());
  EXPECT_EQ(Distance(Perturbed(Json::object(), 1), Ramp()), 0.0);
  EXPECT_EQ(Distance(Perturbed({{"gain", 1}, {"jpeg_quality", 100}}), Ramp()), 0.0);
  EXPECT_FALSE(IsDropped(TenFrames(Json::object()), 3));
}

TEST(Perturbation, AppliesGainThenGammaToEachGreyLevel) {
  const cv::Mat half = Perturbed({{"gain", 0.5}});
  EXPECT_EQ(half.at<unsigned char>(20, 30), 60);  // 0.5 * (3 * 20 + 2 * 30)
  const cv::Mat squared = Perturbed({{"gain", 0.5}, {"gamma", 2}});
  EXPECT_EQ(squared.at<unsigned char>(20, 30), 14);  // 255 (60 / 255)^2
}

TEST(Perturbation, MovesOnlyTheRightImageDownByRows) {
  const cv::Mat right = Perturbed({{"right_late_rows", 2}}, 1);
  EXPECT_EQ(right.at<unsigned char>(10, 7), Ramp().at<unsigned char>(8, 7));
  EXPECT_EQ(right.at<unsigned char>(0, 7), Ramp().at<unsigned char>(0, 7));
  EXPECT_EQ(Distance(Perturbed({{"right_late_rows", 2}}, 0), Ramp()), 0.0);
}

TEST(Perturbation, NoiseDependsOnSeedFrameAndSide) {
  const Json noise = {{"noise", 5}};
  EXPECT_EQ(Distance(Perturbed(noise), Perturbed(noise)), 0.0);
  for (const cv::Mat& other :
       {Perturbed(noise, 1), Perturbed(noise, 0, 3), Perturbed(noise, 0, 2, 9)}) {
    EXPECT_GT(Distance(Perturbed(noise), other), 0.0);
  }
  EXPECT_NEAR(cv::norm(Perturbed(noise), Ramp(), cv::NORM_L2) / std::sqrt(40.0 * 60.0), 5.0, 0.5);
}

TEST(Perturbation, BlurAndCompressionBarelyChangeASmoothImage) {
  for (const Json& mild : {Json{{"blur_px", 1.0}}, Json{{"jpeg_quality", 60}}}) {
    EXPECT_GT(Distance(Perturbed(mild), Ramp()), 0.0) << mild;
    EXPECT_LT(Distance(Perturbed(mild), Ramp()), 12.0) << mild;
  }
}

TEST(Perturbation, ALargerRateDropsTheSameFramesAndMore) {
  const Sequence few = TenFrames({{"drop_rate", 0.3}});
  const Sequence many = TenFrames({{"drop_rate", 0.7}});
  int dropped = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_LE(IsDropped(few, i), IsDropped(many, i)) << i;
    dropped += IsDropped(many, i) ? 1 : 0;
  }
  EXPECT_GT(dropped, 3);
  EXPECT_FALSE(IsDropped(TenFrames({{"drop_rate", 1}}), 0)) << "the first is kept";
  EXPECT_TRUE(IsDropped(TenFrames({{"drop_rate", 1}}), 9));
}

TEST(Perturbation, RepeatedAndLateFramesReadOtherFiles) {
  EXPECT_EQ(TenFrames({{"repeat_rate", 1}}).images[9].left, "l0");
  const Sequence late = TenFrames({{"right_late_frames", 2}});
  EXPECT_EQ(late.images[5].left, "l5");
  EXPECT_EQ(late.images[5].right, "r3");
  EXPECT_EQ(late.images[1].right, "r0");
}

TEST(Perturbation, AppliesCalibrationErrors) {
  const Sequence sequence =
      TenFrames({{"focal_error", 0.1}, {"baseline_error", -0.1}, {"disparity_error_px", 0.5}});
  EXPECT_NEAR(sequence.camera.fx, 770.0, 1e-9);
  EXPECT_NEAR(sequence.camera.baseline_m, 0.45, 1e-12);
  EXPECT_EQ(sequence.camera.right_shift_px, 0.5);
  EXPECT_EQ(PerturbationToJson(sequence.perturbation), Json({{"focal_error", 0.1},
                                                             {"baseline_error", -0.1},
                                                             {"disparity_error_px", 0.5},
                                                             {"seed", 1}}));
}

TEST(Perturbation, BadValuesNameTheKey) {
  const auto error = [](const Json& json) {
    return ErrorMessage([&] { ParsePerturbation(json, "drive, perturb"); });
  };
  EXPECT_THAT(error({{"blur", 1}}), HasSubstr("blur"));
  EXPECT_THAT(error({{"drop_rate", 1.5}}), HasSubstr("drop_rate"));
  EXPECT_THAT(error({{"jpeg_quality", 0}}), HasSubstr("jpeg_quality"));
  EXPECT_THAT(error({{"noise", "x"}}), HasSubstr("noise"));
  EXPECT_THAT(error({{"seed", 3}}), HasSubstr("seed"));
}

}  // namespace
}  // namespace cvo
