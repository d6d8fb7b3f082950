// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/features/front_end.h"
#include "core/features/patch_alignment.h"
#include "tests/core/features/scene.h"

namespace cvo::stereo_test {
namespace {

using test::CameraFor;
using test::Disparity;
using test::DrawScene;
using test::kSubpixelSteps;
using test::MatchImages;
using test::Render;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct Errors {
  int count = 0;
  int gross = 0;  // more than 1 px
  double mean = 0.0;
  double rms = 0.0;
};

template <typename Truth>
Errors Measure(const std::vector<StereoFeature>& features, Truth truth) {
  Errors errors;
  for (const StereoFeature& feature : features) {
    const double error = Disparity(feature) - truth(feature);
    if (std::abs(error) > 1.0) {
      ++errors.gross;
      continue;
    }
    ++errors.count;
    errors.mean += error;
    errors.rms += error * error;
  }
  errors.mean /= std::max(errors.count, 1);
  errors.rms = std::sqrt(errors.rms / std::max(errors.count, 1));
  return errors;
}

TEST(MatchStereo, SubPixelDisparityIsUnbiased) {
  const cv::Mat scene = DrawScene(320, 240, 1);
  const cv::Mat left = Render(scene, 0, 2.0, 1);
  for (int eighths = 0; eighths < kSubpixelSteps; ++eighths) {
    const cv::Mat right = Render(scene, 20 * kSubpixelSteps + eighths, 2.0, 2 + eighths);
    const double truth = 20.0 + eighths / static_cast<double>(kSubpixelSteps);
    const Errors errors = Measure(MatchImages(left, right), [&](const auto&) { return truth; });
    EXPECT_GT(errors.count, 400);
    EXPECT_EQ(errors.gross, 0);
    // Measured: bias up to 0.015, RMS 0.035 px over all octaves.
    EXPECT_NEAR(errors.mean, 0.0, 0.025) << eighths;
    EXPECT_LT(errors.rms, 0.06) << eighths;
  }
}

TEST(AlignPatch, QuartersDisagreeAtDepthDiscontinuities) {
  const cv::Mat scene = DrawScene(320, 240, 5);
  const cv::Mat left = Render(scene, 0, 2.0, 1);
  const cv::Mat far = Render(scene, 8 * kSubpixelSteps, 2.0, 2);
  const cv::Mat near = Render(scene, 9 * kSubpixelSteps, 2.0, 3);
  std::vector<double> even;
  std::vector<double> jumping;
  for (int u = 60; u < 300; u += 8) {
    const PatchQuery query{.u_left = static_cast<double>(u),
                           .v_left = 120.0,
                           .u_right = u - 8.0,
                           .v_right = 120.0,
                           .patch_radius = 7,
                           .search_radius = 4};
    cv::Mat both = far.clone();
    near.colRange(u - 8, near.cols).copyTo(both.colRange(u - 8, near.cols));
    const auto one = AlignPatch(left, far, query);
    const auto two = AlignPatch(left, both, query);
    if (one) even.push_back(one->disagreement);
    if (two) jumping.push_back(two->disagreement);
  }
  ASSERT_GT(jumping.size(), 10U);
  EXPECT_GT(Median(jumping), 3.0 * Median(even));
}

TEST(MatchStereo, RepetitiveTextureIsMostlyRejected) {
  // A tile of 40 px repeats, so every position in a row has competing matches.
  const cv::Mat tile = DrawScene(40, 240, 4).colRange(0, 40 * kSubpixelSteps);
  cv::Mat scene;
  cv::repeat(tile, 1, (320 + test::kMargin_px) / 40 + 1, scene);
  scene = scene.colRange(0, (320 + test::kMargin_px) * kSubpixelSteps).clone();
  const cv::Mat left = Render(scene, 0, 2.0, 1);
  const cv::Mat right = Render(scene, 12 * kSubpixelSteps, 2.0, 2);
  const auto truth = [](const StereoFeature&) { return 12.0; };
  StereoMatchOptions credulous;
  credulous.uniqueness = 1.0;
  credulous.min_margin_bits = 0;
  const Errors without = Measure(MatchImages(left, right, credulous), truth);
  const Errors with = Measure(MatchImages(left, right), truth);
  // Measured: 509 -> 110. The remaining ones have no competitor among the corners of the right
  // image.
  EXPECT_GT(without.gross, 300);
  EXPECT_LT(with.gross, without.gross / 3);
}

TEST(MatchStereo, OccludedCornersAreNotMatched) {
  const cv::Mat far_scene = DrawScene(320, 240, 5);
  const cv::Mat near_scene = DrawScene(320, 240, 6);
  cv::Mat left = Render(far_scene, 0, 2.0, 1);
  cv::Mat right = Render(far_scene, 6 * kSubpixelSteps, 2.0, 2);
  // A near rectangle with 30 px of disparity, in columns [150, 230) of the left image.
  const cv::Rect in_left(150, 60, 80, 120);
  const cv::Rect in_right(120, 60, 80, 120);
  Render(near_scene, 0, 2.0, 3)(in_left).copyTo(left(in_left));
  Render(near_scene, 30 * kSubpixelSteps, 2.0, 4)(in_right).copyTo(right(in_right));
  int near_count = 0;
  int wrong = 0;
  const std::vector<StereoFeature> features = MatchImages(left, right);
  for (const StereoFeature& feature : features) {
    const bool is_near = std::abs(Disparity(feature) - 30.0) < 1.0;
    const bool is_far = std::abs(Disparity(feature) - 6.0) < 1.0;
    near_count += is_near;
    wrong += !is_near && !is_far;
  }
  EXPECT_GT(features.size(), 300u);
  EXPECT_GT(near_count, 50);
  EXPECT_LE(wrong, static_cast<int>(features.size()) / 100);
}

TEST(MatchStereo, CorrectsRowsOfAFaultyRectificationAsFarAsAllowed) {
  const cv::Mat scene = DrawScene(320, 240, 7);
  const cv::Mat left = Render(scene, 0);
  const cv::Mat level = Render(scene, 15 * kSubpixelSteps);
  cv::Mat right = level.clone();  // one row too low
  level.rowRange(0, 239).copyTo(right.rowRange(1, 240));
  const auto truth = [](const StereoFeature&) { return 15.0; };
  StereoMatchOptions options;
  options.max_row_correction_px = 0.0;
  const Errors trusting = Measure(MatchImages(left, right, options), truth);
  options.max_row_correction_px = 2.0;
  const Errors following = Measure(MatchImages(left, right, options), truth);
  EXPECT_GT(following.count, 400);
  EXPECT_LT(following.rms, 0.06);
  EXPECT_GT(trusting.rms, 1.5 * following.rms);
}

TEST(ExtractStereoFeatures, DoesNotDependOnTheNumberOfThreads) {
  const cv::Mat scene = DrawScene(320, 240, 9);
  const cv::Mat left = Render(scene, 0);
  const cv::Mat right = Render(scene, 10 * kSubpixelSteps);
  std::vector<std::vector<StereoFeature>> results;
  for (int threads : {1, 2, 2}) {
    TaskPool pool(threads);
    results.push_back(ExtractStereoFeatures(left, right, CameraFor(left), {}, {}, pool));
  }
  ASSERT_GT(results[0].size(), 400u);
  for (int run : {1, 2}) {
    ASSERT_EQ(results[run].size(), results[0].size());
    for (std::size_t i = 0; i < results[0].size(); ++i) {
      EXPECT_EQ(results[run][i].z_px, results[0][i].z_px);
      EXPECT_EQ(results[run][i].descriptor, results[0][i].descriptor);
      EXPECT_EQ(results[run][i].angle_rad, results[0][i].angle_rad);
      EXPECT_EQ(results[run][i].octave, results[0][i].octave);
      EXPECT_EQ(results[run][i].response, results[0][i].response);
    }
  }
}

TEST(ExtractStereoFeatures, KeepsCornersInBoxesOutsideTheRightImage) {
  const cv::Mat scene = DrawScene(320, 240, 9);
  const cv::Mat left = Render(scene, 0);
  const cv::Mat right = Render(scene, 40 * kSubpixelSteps);
  const cv::Rect2d box(0, 60, 38, 120);  // outside the field of view of the right image
  TaskPool pool(1);
  const OrbOptions orb = {.reserve = 0.0, .box_features = 0};
  const auto found = [&](const std::vector<cv::Rect2d>& boxes) {
    return ExtractStereoFeatures(left, right, CameraFor(left), orb, {}, pool, {&boxes, 1});
  };
  const auto is_pair = [](const StereoFeature& feature) { return !IsLeftOnly(feature); };
  const std::vector<StereoFeature> without = found({});
  EXPECT_TRUE(std::all_of(without.begin(), without.end(), is_pair));
  std::vector<StereoFeature> with = found({box});
  const auto inside = [&](const StereoFeature& feature) {
    return box.contains({feature.z_px[0], feature.z_px[1]});
  };
  EXPECT_TRUE(std::is_sorted(with.begin(), with.end(),
                             [](const auto& a, const auto& b) { return a.z_px[1] < b.z_px[1]; }));
  int left_only = 0;
  for (const StereoFeature& feature : with) {
    if (is_pair(feature)) continue;
    ++left_only;
    EXPECT_TRUE(inside(feature));
    EXPECT_EQ(feature.z_px[2], feature.z_px[0]);
  }
  EXPECT_GT(left_only, 10);
  std::erase_if(with, IsLeftOnly<StereoFeature>);
  EXPECT_EQ(with.size(), without.size());
}

TEST(ExtractStereoFeatures, ErrorsDescribeTheBadImage) {
  const cv::Mat good(240, 320, CV_8UC1, cv::Scalar(0));
  TaskPool pool(1);
  const auto extract = [&](const cv::Mat& left, const cv::Mat& right) {
    return [&pool, &good, left, right] {
      ExtractStereoFeatures(left, right, CameraFor(good), {}, {}, pool);
    };
  };
  EXPECT_THAT(extract(cv::Mat(), good),
              ThrowsMessage<Error>(HasSubstr("left image: found no pixels, expected 320 x 240")));
  EXPECT_THAT(extract(good, cv::Mat(240, 320, CV_8UC3)),
              ThrowsMessage<Error>(HasSubstr("right image: found 320 x 240 CV_8UC3")));
  EXPECT_THAT(extract(good, cv::Mat(240, 319, CV_8UC1)),
              ThrowsMessage<Error>(HasSubstr("found 319 x 240 CV_8UC1")));
}

}  // namespace
}  // namespace cvo::stereo_test
