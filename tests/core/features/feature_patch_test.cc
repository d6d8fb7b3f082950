// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/feature_patch.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace cvo {
namespace {

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

class AlignFeaturePatchTest : public ::testing::TestWithParam<View> {};

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
  EXPECT_EQ(shift, AlignFeaturePatchPlain(Reference(), seen, view.zoom));
}

Eigen::Matrix2d Deformation(double a, double b, double c, double d) {
  return (Eigen::Matrix2d() << a, b, c, d).finished();
}

INSTANTIATE_TEST_SUITE_P(
    Views, AlignFeaturePatchTest,
    ::testing::Values(View{{0.0, 0.0}, Deformation(1, 0, 0, 1), 1.0, 0.0},
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

TEST(AlignFeaturePatch, RefusesPatchesWithoutTexture) {
  EXPECT_EQ(AlignFeaturePatch(FeaturePatch(), FeaturePatch(), 1.0), std::nullopt);
}

TEST(AlignFeaturePatch, RefusesAZoomThatLeavesThePatch) {
  EXPECT_EQ(AlignFeaturePatch(Reference(), Reference(), 2.0), std::nullopt);
}

}  // namespace
}  // namespace cvo
