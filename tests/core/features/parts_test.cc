// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/features/descriptor.h"
#include "core/features/feature_patch.h"
#include "core/features/options.h"
#include "core/features/orb/corner_score.h"
#include "core/features/orb/orb.h"
#include "core/features/stereo_matcher.h"
#include "tests/core/features/scene.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::parts_test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

cv::Mat RandomImage(int width_px, int height_px) {
  Rng rng(1, "test image");
  cv::Mat image(height_px, width_px, CV_8UC1);
  for (int v = 0; v < height_px; ++v) {
    for (int u = 0; u < width_px; ++u) {
      image.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(rng.UniformInt(256));
    }
  }
  return image;
}

TEST(HammingDistance, CountsDifferingBits) {
  const Descriptor zero{};
  const Descriptor ones{~0ull, ~0ull, ~0ull, ~0ull};
  EXPECT_EQ(HammingDistance(zero, zero), 0);
  EXPECT_EQ(HammingDistance(zero, ones), 256);
  EXPECT_EQ(HammingDistance(zero, Descriptor{1, 0, 3, 1ull << 63}), 4);
}

// Reference implementation: evaluates all arcs by definition.
int FastScoreOf(const cv::Mat& image, int x, int y) {
  constexpr int kX[16] = {0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3, -3, -3, -2, -1};
  constexpr int kY[16] = {3, 3, 2, 1, 0, -1, -2, -3, -3, -3, -2, -1, 0, 1, 2, 3};
  int best = 0;
  for (int sign : {-1, 1}) {
    for (int start = 0; start < 16; ++start) {
      int least = 255;
      for (int i = 0; i < 9; ++i) {
        const int k = (start + i) % 16;
        const int ring = image.at<std::uint8_t>(y + kY[k], x + kX[k]);
        least = std::min(least, sign * (ring - image.at<std::uint8_t>(y, x)));
      }
      best = std::max(best, least);
    }
  }
  return best;
}

TEST(FastScores, MatchTheDefinition) {
  cv::Mat image = RandomImage(101, 40);
  cv::GaussianBlur(image, image, cv::Size(5, 5), 1.5);  // so that there are corners
  cv::Mat scores(image.size(), CV_8UC1);
  ComputeFastScores(image, scores);
  int corners = 0;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const bool inside = x >= 3 && y >= 3 && x < image.cols - 3 && y < image.rows - 3;
      const int expected = inside ? FastScoreOf(image, x, y) : 0;
      ASSERT_EQ(scores.at<std::uint8_t>(y, x), expected) << x << " " << y;
      if (expected > 7) ++corners;
    }
  }
  EXPECT_GT(corners, 50);
}

TEST(Pyramid, LevelsAreAlignedAndShareOneStride) {
  cv::Mat ramp(120, 250, CV_8UC1);
  for (int v = 0; v < ramp.rows; ++v) {
    for (int u = 0; u < ramp.cols; ++u) ramp.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(u);
  }
  const std::vector<cv::Mat> pyramid = BuildPyramid(ramp, 8, 1.2, 10);
  ASSERT_EQ(pyramid.size(), 8u);
  for (int level = 0; level < 8; ++level) {
    const cv::Mat& image = pyramid[level];
    EXPECT_EQ(image.step, pyramid[0].step);
    EXPECT_EQ(image.cols, cvRound(250.0 * std::pow(1.2, -level)));
    const LevelCoordinates coordinates(pyramid, level);
    for (int u = 2; u < image.cols - 2; ++u) {
      // Each level rounds to integer grey values.
      EXPECT_NEAR(image.at<std::uint8_t>(image.rows / 2, u), coordinates.FullU(u), 2.0);
      EXPECT_NEAR(coordinates.LevelU(coordinates.FullU(u)), u, 1e-12);
    }
    const double mean = cv::mean(image)[0];
    EXPECT_NEAR(mean, 124.5, 0.3) << level;  // no drift of brightness or position
  }
}

// The mean of the image over an interval of columns and one of rows.
double AreaMean(const cv::Mat& image, double u0, double u1, double v0, double v1) {
  double sum = 0.0;
  for (int v = static_cast<int>(v0); v < v1 && v < image.rows; ++v) {
    const double rows = std::min(v + 1.0, v1) - std::max<double>(v, v0);
    for (int u = static_cast<int>(u0); u < u1 && u < image.cols; ++u) {
      const double columns = std::min(u + 1.0, u1) - std::max<double>(u, u0);
      sum += rows * columns * image.at<std::uint8_t>(v, u);
    }
  }
  return sum / ((u1 - u0) * (v1 - v0));
}

TEST(Pyramid, PixelsAreMeansOfTheLevelBefore) {
  for (const double scale_factor : {1.2, 2.0}) {
    const std::vector<cv::Mat> pyramid = BuildPyramid(RandomImage(157, 70), 3, scale_factor, 10);
    for (std::size_t level = 1; level < pyramid.size(); ++level) {
      const cv::Mat& from = pyramid[level - 1];
      const cv::Mat& image = pyramid[level];
      const double du = static_cast<double>(from.cols) / image.cols;
      const double dv = static_cast<double>(from.rows) / image.rows;
      for (int v = 0; v < image.rows; ++v) {
        for (int u = 0; u < image.cols; ++u) {
          ASSERT_NEAR(image.at<std::uint8_t>(v, u),
                      AreaMean(from, u * du, (u + 1) * du, v * dv, (v + 1) * dv), 2.0)
              << scale_factor << " " << level << ": " << u << " " << v;
        }
      }
    }
  }
}

const StereoCamera kRowCamera = test::CentredCamera(500.0, 0.5, 600, 200);

// Row offsets with a fifth of outliers, of a rig whose baseline is not level.
class RowOffsets : public testing::Test {
 protected:
  static double Truth(double u, double v, double disparity) {
    return 0.4 - 1e-3 * u + 5e-6 * (u - 300) * (v - 100) + 0.004 * disparity;
  }
  std::vector<RowOffset> Draw(int count) {
    std::vector<RowOffset> samples;
    for (int i = 0; i < count; ++i) {
      const double u = rng_.Uniform(0.0, 600.0);
      const double v = rng_.Uniform(0.0, 200.0);
      const double disparity = rng_.Uniform(0.0, 60.0);
      const double noise = i % 5 == 0 ? rng_.Uniform(-3.0, 3.0) : 0.3 * rng_.Normal();
      samples.push_back({u, v, disparity, Truth(u, v, disparity) + noise, 0.4});
    }
    return samples;
  }
  static double WorstError(const RowField& rows) {
    double worst = 0.0;
    for (const double u : {0.0, 300.0, 599.0}) {
      for (const double v : {0.0, 199.0}) {
        for (const double disparity : {0.0, 50.0}) {
          const double error = rows.At(kRowCamera, u, v, disparity) - Truth(u, v, disparity);
          worst = std::max(worst, std::abs(error));
        }
      }
    }
    return worst;
  }

  Rng rng_{4, "offsets"};
};

TEST_F(RowOffsets, FitIsRobustToOutliers) {
  RowField rows;
  EXPECT_EQ(rows.At(kRowCamera, 10.0, 10.0, 5.0), 0.0);
  rows.Add({}, kRowCamera);
  EXPECT_EQ(rows.At(kRowCamera, 10.0, 10.0, 5.0), 0.0);
  rows.Add(Draw(3000), kRowCamera);
  EXPECT_LT(WorstError(rows), 0.15);
}

TEST_F(RowOffsets, EveryPairMakesTheFieldMoreCertain) {
  RowField rows;
  double deviation_px = 1.0;
  for (int pair = 0; pair < 30; ++pair) {
    rows.Add(Draw(300), kRowCamera);
    const double now_px = std::sqrt(rows.Covariance()(0, 0));
    EXPECT_LT(now_px, deviation_px);
    deviation_px = now_px;
  }
  EXPECT_LT(deviation_px, 0.02);
  EXPECT_LT(WorstError(rows), 0.06);
}

TEST(FeatureOptions, ThresholdsAreOrdered) {
  OrbOptions options;
  options.fast_threshold = 10;
  options.fast_threshold_min = 11;
  EXPECT_THAT([&] { options.Check(); },
              ThrowsMessage<Error>(HasSubstr("fast_threshold_min: found 11, expected at most")));
}

// A texture that is not periodic within the patch, with structures of a few pixels.
double TextureAt(const Eigen::Vector2d& p) {
  return 128.0 + 40.0 * std::sin(0.9 * p.x() + 0.3 * p.y()) + 30.0 * std::cos(0.7 * p.y()) +
         25.0 * std::sin(0.5 * p.x() - 0.8 * p.y() + 1.0);
}

// Draws the texture as a camera sees it. The origin of the texture is at `at_px` from the middle of
// the patch; A maps texture units to pixels.
FeaturePatch Draw(const Eigen::Vector2d& at_px, const Eigen::Matrix2d& A, double brightness = 0.0) {
  FeaturePatch patch;
  for (int y = 0; y < FeaturePatch::kSide_px; ++y) {
    for (int x = 0; x < FeaturePatch::kSide_px; ++x) {
      const Eigen::Vector2d from_corner =
          Eigen::Vector2d(x - FeaturePatch::kRadius_px, y - FeaturePatch::kRadius_px) - at_px;
      patch.pixels[y * FeaturePatch::kSide_px + x] =
          static_cast<std::uint8_t>(std::lround(TextureAt(A.inverse() * from_corner) + brightness));
    }
  }
  return patch;
}

FeaturePatch Reference() {
  FeaturePatch patch = Draw({0.3, -0.4}, Eigen::Matrix2d::Identity());
  patch.corner_u = 0.3F;
  patch.corner_v = -0.4F;
  return patch;
}

struct View {
  Eigen::Vector2d shift_px;
  Eigen::Matrix2d deformation;
  double zoom;
  double brightness;
};

class AlignFeaturePatchTest : public testing::TestWithParam<View> {};

TEST_P(AlignFeaturePatchTest, FindsTheCorner) {
  const View& view = GetParam();
  FeaturePatch seen = Draw(view.shift_px + Eigen::Vector2d(-0.2, 0.1), view.zoom * view.deformation,
                           view.brightness);
  seen.corner_u = -0.2F;
  seen.corner_v = 0.1F;
  const auto shift = AlignFeaturePatch(Reference(), seen, view.zoom);
  ASSERT_TRUE(shift.has_value());
  EXPECT_NEAR(shift->x(), view.shift_px.x(), 0.03);
  EXPECT_NEAR(shift->y(), view.shift_px.y(), 0.03);
}

Eigen::Matrix2d Deformation(double a, double b, double c, double d) {
  return (Eigen::Matrix2d() << a, b, c, d).finished();
}

INSTANTIATE_TEST_SUITE_P(
    Views, AlignFeaturePatchTest,
    testing::Values(View{{0.0, 0.0}, Deformation(1, 0, 0, 1), 1.0, 0.0},
                    View{{0.7, -0.6}, Deformation(1, 0, 0, 1), 1.0, 12.0},
                    View{{-0.5, 0.8}, Deformation(1, 0, 0, 1), 1.2, 0.0},
                    View{{0.4, 0.3}, Deformation(1, 0, 0, 1), 0.85, -8.0},
                    View{{0.3, 0.2}, Deformation(1, 0, 0, 1.12), 1.1, 0.0},
                    View{{-0.4, 0.5}, Deformation(1, 0.1, -0.05, 1.05), 1.0, 0.0}));

TEST(AlignFeaturePatch, RefusesDissimilarPatches) {
  FeaturePatch negative = Reference();
  for (std::uint8_t& pixel : negative.pixels) pixel = static_cast<std::uint8_t>(255 - pixel);
  EXPECT_EQ(AlignFeaturePatch(Reference(), negative, 1.0), std::nullopt);
}

}  // namespace
}  // namespace cvo::parts_test
