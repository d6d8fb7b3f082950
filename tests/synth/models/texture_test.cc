// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/models/textures/texture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "synth/models/make_model.h"
#include "tests/support/error_message.h"

namespace cvo::synth {
namespace {

using testing::HasSubstr;

bool SameImage(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

TEST(Textures, AreInColourWithPowerOfTwoSizes) {
  Rng rng(0, "test");
  for (const std::string& material : MaterialNames()) {
    const Texture texture = MakeTexture(material, rng);
    EXPECT_EQ(texture.image.type(), CV_8UC3) << material;
    EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(texture.image.cols))) << material;
    EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(texture.image.rows))) << material;
    EXPECT_LE(std::max(texture.image.cols, texture.image.rows), 1024) << material;
    EXPECT_GT(texture.size_m.minCoeff(), 0.0) << material;
  }
}

TEST(Textures, AreFixedPerStream) {
  for (const std::string& material : MaterialNames()) {
    Rng first(3, "look");
    Rng again(3, "look");
    Rng other(4, "look");
    const cv::Mat image = MakeTexture(material, first).image;
    EXPECT_TRUE(SameImage(image, MakeTexture(material, again).image)) << material;
    EXPECT_FALSE(SameImage(image, MakeTexture(material, other).image)) << material;
    EXPECT_FALSE(SameImage(image, MakeTexture(material, first).image)) << material;
  }
}

// The grey-level step across the border, where the texture repeats, is no larger than those inside.
TEST(Textures, AreSeamless) {
  Rng rng(1, "test");
  for (const char* material : {"asphalt", "brick", "concrete", "grass", "leaves", "pavement",
                               "plaster", "tiles", "wallpaper", "parquet"}) {
    cv::Mat grey;
    cv::cvtColor(MakeTexture(material, rng).image, grey, cv::COLOR_RGB2GRAY);
    const auto step = [&](int a, int b) {
      return cv::norm(grey.col(a), grey.col(b), cv::NORM_L1) / grey.rows;
    };
    double largest = 0.0;
    for (int x = 0; x + 1 < grey.cols; ++x) largest = std::max(largest, step(x, x + 1));
    EXPECT_LE(step(grey.cols - 1, 0), 1.1 * largest) << material;
  }
}

// Returns the number of corners per 1,000 pixels of the texture at this resolution.
double CornerDensity(const Texture& texture, double pixels_per_m) {
  cv::Mat grey;
  cv::cvtColor(texture.image, grey, cv::COLOR_RGB2GRAY);
  const cv::Size size(static_cast<int>(texture.size_m.x() * pixels_per_m),
                      static_cast<int>(texture.size_m.y() * pixels_per_m));
  cv::Mat seen;
  cv::resize(grey, seen, size, 0, 0, cv::INTER_AREA);
  cv::Mat repeated;
  cv::repeat(seen, 2, 2, repeated);
  std::vector<cv::KeyPoint> corners;
  cv::FAST(repeated, corners, 20);
  return 1000.0 * static_cast<double>(corners.size()) / static_cast<double>(repeated.total());
}

double MeanDensity(const std::string& material, double pixels_per_m) {
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Rng rng(seed, "corners");
    sum += CornerDensity(MakeTexture(material, rng), pixels_per_m) / 3.0;
  }
  return sum;
}

// Moving bodies have more corners than their background, or they would not get their share of the
// features that a front end keeps. The upper walls have almost none.
TEST(Textures, HaveCornersAtTwoMetresIndoorsWhereTheyAreNeeded) {
  const auto density = [](const char* material) { return MeanDensity(material, 450.0 / 2.0); };
  for (const char* material : {"ball", "block", "fabric"}) {
    EXPECT_GE(density(material), 10.0) << material;
  }
  for (const char* material : {"brick", "plaster", "poster", "tiles", "wallpaper", "wood"}) {
    EXPECT_GE(density(material), 5.0) << material;
  }
  EXPECT_GE(density("carpet"), 1.0);
  EXPECT_LE(density("embossed"), 0.5);
}

// Cars have more corners than the objects along the road, and these more than the road itself, or
// they would not get their share of the features that a front end keeps.
TEST(Textures, HaveCornersAtFifteenMetresOutdoorsWhereTheyAreNeeded) {
  const auto density = [](const char* material) { return MeanDensity(material, 721.0 / 15.0); };
  EXPECT_GE(density("paint"), 20.0);
  for (const char* material : {"bark", "brick", "concrete", "grass", "leaves", "roof"}) {
    EXPECT_GE(density(material), 4.0) << material;
  }
  EXPECT_GE(density("facade"), 2.0);
  EXPECT_LE(density("facade"), 8.0);
  for (const char* material : {"asphalt", "pavement"}) {
    EXPECT_GE(density(material), 0.2) << material;
    EXPECT_LE(density(material), 2.0) << material;
  }
}

TEST(Textures, RefuseUnknownMaterials) {
  Rng rng(0, "test");
  EXPECT_THAT(ErrorMessage([&] { MakeTexture("cheese", rng); }),
              AllOf(HasSubstr("'cheese'"), HasSubstr("asphalt, ball")));
}

}  // namespace
}  // namespace cvo::synth
