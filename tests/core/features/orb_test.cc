// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "core/base/error.h"
#include "core/features/descriptor.h"
#include "tests/core/features/scene.h"

namespace cvo::orb_test {
namespace {

using test::DrawScene;
using test::Render;

cv::Mat Textured(int width_px, int height_px) {
  return Render(DrawScene(width_px, height_px, 1), 0);
}

// Returns the corner with the nearest descriptor within 2 px of the expected position (u, v); null
// if there is none.
const OrbKeypoint* FindPartner(const OrbKeypoint& corner, const OrbImage& image, double u,
                               double v) {
  const OrbKeypoint* best = nullptr;
  int best_distance = 64;
  for (const OrbKeypoint& other : image.keypoints) {
    if (std::hypot(other.u_px - u, other.v_px - v) > 2.0) continue;
    const int distance = HammingDistance(corner.descriptor, other.descriptor);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = &other;
  }
  return best;
}

TEST(ExtractOrb, ReturnsTheRequestedNumberSortedByRow) {
  OrbOptions options;
  options.features = 500;
  options.reserve = 0.0;
  const OrbImage orb = ExtractOrb(Textured(320, 240), options);
  EXPECT_EQ(orb.keypoints.size(), 500u);
  const auto key = [](const OrbKeypoint& k) { return std::tie(k.v_px, k.u_px, k.octave); };
  EXPECT_TRUE(std::is_sorted(orb.keypoints.begin(), orb.keypoints.end(),
                             [&](const auto& a, const auto& b) { return key(a) < key(b); }));
  std::map<int, int> by_octave;
  for (const OrbKeypoint& keypoint : orb.keypoints) ++by_octave[keypoint.octave];
  EXPECT_GT(by_octave[0], by_octave[3]);
  EXPECT_GT(by_octave[3], 0);
}

TEST(ExtractOrb, ReserveIsAddedWithoutChangingTheOthers) {
  OrbOptions options;
  options.features = 200;
  options.reserve = 0.0;
  const cv::Mat image = Textured(320, 240);
  const OrbImage alone = ExtractOrb(image, options);
  options.reserve = 0.5;
  EXPECT_EQ(ExtractOrb(image, options).keypoints.size(), 200u);  // the reserve is for regions
  const CornerRegion whole{cv::Rect2d(0.0, 0.0, 320.0, 240.0), 0};
  const OrbImage both = ExtractOrb(image, options, {&whole, 1});
  EXPECT_EQ(both.keypoints.size(), 300u);
  const auto key = [](const OrbKeypoint& k) { return std::tie(k.v_px, k.u_px, k.octave); };
  std::vector<OrbKeypoint> first;
  for (const OrbKeypoint& keypoint : both.keypoints) {
    if (!keypoint.is_reserve) first.push_back(keypoint);
  }
  ASSERT_EQ(first.size(), alone.keypoints.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(key(first[i]), key(alone.keypoints[i]));
  }
  EXPECT_TRUE(std::is_sorted(both.keypoints.begin(), both.keypoints.end(),
                             [&](const auto& a, const auto& b) { return key(a) < key(b); }));
}

// Number of corners inside the box, and of all reserve corners of the image.
struct RegionCount {
  int inside = 0;
  int reserve = 0;
};
RegionCount CountIn(const cv::Rect2d& box, const OrbImage& image) {
  RegionCount count;
  for (const OrbKeypoint& keypoint : image.keypoints) {
    count.inside += box.contains({keypoint.u_px, keypoint.v_px}) ? 1 : 0;
    count.reserve += keypoint.is_reserve ? 1 : 0;
  }
  return count;
}

TEST(ExtractOrb, ReserveGoesToRegions) {
  OrbOptions options;
  options.features = 200;
  options.reserve = 0.5;
  const cv::Mat image = Textured(320, 240);
  const cv::Rect2d box(140.0, 100.0, 30.0, 30.0);
  const RegionCount evenly = CountIn(box, ExtractOrb(image, options));
  const CornerRegion region{box, 30};
  const RegionCount favoured = CountIn(box, ExtractOrb(image, options, {&region, 1}));
  EXPECT_LT(evenly.inside, 10);
  EXPECT_GE(favoured.inside, 20);
  EXPECT_LE(favoured.inside, 32);  // refinement moves corners across the edge
  EXPECT_GE(favoured.reserve, favoured.inside - evenly.inside);
}

TEST(LeftRegions, AreTheNewestBoxesAndOlderOnesNotDetectedAgain) {
  OrbOptions orb;
  orb.box_features = 40;
  const std::vector<std::vector<cv::Rect2d>> boxes{
      {{400.0, 100.0, 20.0, 20.0}},                              // too old
      {{300.0, 100.0, 50.0, 40.0}, {100.0, 100.0, 20.0, 10.0}},  // the first is detected again
      {},
      {{305.0, 102.0, 50.0, 40.0}}};
  const std::vector<CornerRegion> regions = LeftRegions(boxes, orb);
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].box, boxes[3][0]);
  EXPECT_EQ(regions[0].corners, 40);
  EXPECT_EQ(regions[1].box, cv::Rect2d(96.0, 98.0, 28.0, 14.0));
  EXPECT_EQ(regions[1].corners, 0);
  EXPECT_TRUE(LeftRegions({}, orb).empty());
}

TEST(RightRegions, ExtendToTheLargestDisparityAtTheSameDensity) {
  const StereoCamera camera{450.0, 450.0, 319.5, 239.5, 0.12, 640, 480};
  StereoMatchOptions stereo;
  stereo.right_features = 1.5;
  stereo.min_depth_baselines = 3.0;  // 150 px
  const auto regions = RightRegions(
      {{{300.0, 100.0, 50.0, 40.0}, 40}, {{30.0, 0.0, 60.0, 20.0}, 40}}, stereo, camera);
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].box, cv::Rect2d(150.0, 100.0, 200.0, 40.0));
  EXPECT_EQ(regions[0].corners, 240);
  EXPECT_EQ(regions[1].box, cv::Rect2d(0.0, 0.0, 90.0, 20.0));
  EXPECT_EQ(regions[1].corners, 90);
}

TEST(ExtractOrb, CoversWeakRegions) {
  cv::Mat image = Textured(480, 240);
  cv::Mat weak = image.colRange(160, 480);
  weak.convertTo(weak, CV_8U, 0.15, 100.0);
  const OrbImage orb = ExtractOrb(image, OrbOptions{});
  std::set<std::pair<int, int>> cells;
  int in_weak_region = 0;
  for (const OrbKeypoint& keypoint : orb.keypoints) {
    cells.insert({static_cast<int>(keypoint.u_px) / 40, static_cast<int>(keypoint.v_px) / 40});
    if (keypoint.u_px >= 165.0F) ++in_weak_region;
  }
  EXPECT_GE(cells.size(), 69u);  // of 12 * 6; the border of 16 px loses no whole cell
  EXPECT_GT(in_weak_region, static_cast<int>(orb.keypoints.size()) / 3);
}

TEST(ExtractOrb, AngleFollowsRotation) {
  const cv::Mat image = Textured(320, 320);
  const double angle_rad = 0.6;
  const cv::Point2f centre(159.5F, 159.5F);
  // OpenCV rotates counter-clockwise on screen for positive angles; here v points down.
  const cv::Mat turn = cv::getRotationMatrix2D(centre, -angle_rad * 180.0 / std::numbers::pi, 1.0);
  cv::Mat rotated;
  cv::warpAffine(image, rotated, turn, image.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT_101);
  const OrbImage before = ExtractOrb(image, OrbOptions{});
  const OrbImage after = ExtractOrb(rotated, OrbOptions{});
  int partners = 0;
  int good_angles = 0;
  for (const OrbKeypoint& corner : before.keypoints) {
    const double x = corner.u_px - centre.x;
    const double y = corner.v_px - centre.y;
    if (std::hypot(x, y) > 120.0) continue;
    const OrbKeypoint* partner =
        FindPartner(corner, after, centre.x + std::cos(angle_rad) * x - std::sin(angle_rad) * y,
                    centre.y + std::sin(angle_rad) * x + std::cos(angle_rad) * y);
    if (partner == nullptr) continue;
    ++partners;
    const double turned = partner->angle_rad - corner.angle_rad - angle_rad;
    if (std::abs(std::remainder(turned, 2.0 * std::numbers::pi)) < 0.15) ++good_angles;
  }
  EXPECT_GT(partners, 200);
  EXPECT_GT(good_angles, 9 * partners / 10);
}

TEST(ExtractOrb, OctaveFollowsScale) {
  const cv::Mat image = Textured(320, 320);
  const double scale = 1.44;
  cv::Mat larger;
  cv::resize(image, larger, cv::Size(461, 461), 0.0, 0.0, cv::INTER_CUBIC);
  const OrbImage before = ExtractOrb(image, OrbOptions{});
  const OrbImage after = ExtractOrb(larger, OrbOptions{});
  std::map<int, int> changes;
  for (const OrbKeypoint& corner : before.keypoints) {
    const OrbKeypoint* partner = FindPartner(corner, after, (corner.u_px + 0.5) * scale - 0.5,
                                             (corner.v_px + 0.5) * scale - 0.5);
    if (partner != nullptr) ++changes[partner->octave - corner.octave];
  }
  const auto most = std::max_element(changes.begin(), changes.end(),
                                     [](auto& a, auto& b) { return a.second < b.second; });
  ASSERT_NE(most, changes.end());
  EXPECT_EQ(most->first, 2);
  EXPECT_GT(most->second, 200);
}

TEST(ExtractOrb, FlatImageHasNoCorners) {
  EXPECT_TRUE(ExtractOrb(cv::Mat(240, 320, CV_8UC1, cv::Scalar(90)), {}).keypoints.empty());
}

TEST(ExtractOrb, TinyImages) {
  const cv::Mat image = Textured(64, 64);
  for (const cv::Size size :
       {cv::Size(40, 30), cv::Size(33, 33), cv::Size(34, 40), cv::Size(1, 1), cv::Size(64, 2)}) {
    const OrbImage orb = ExtractOrb(image(cv::Rect(cv::Point(0, 0), size)), OrbOptions{});
    EXPECT_FALSE(orb.pyramid.empty());
    for (const OrbKeypoint& keypoint : orb.keypoints) {
      EXPECT_GE(keypoint.u_px, 0.0F);
      EXPECT_LT(keypoint.u_px, static_cast<float>(size.width));
    }
  }
}

TEST(ExtractOrb, RejectsOtherImageTypes) {
  EXPECT_THROW(ExtractOrb(cv::Mat(), {}), Error);
  EXPECT_THROW(ExtractOrb(cv::Mat(100, 100, CV_8UC3), {}), Error);
}

}  // namespace
}  // namespace cvo::orb_test
