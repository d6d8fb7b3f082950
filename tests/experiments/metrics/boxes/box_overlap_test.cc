// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "experiments/metrics/boxes/average_precision.h"

namespace cvo::box_overlap_test {
namespace {

constexpr double kPi = 3.14159265358979323846;

ObjectBox ImageBox(double left, double top, double right, double bottom) {
  ObjectBox box;
  box.left_px = left;
  box.top_px = top;
  box.right_px = right;
  box.bottom_px = bottom;
  return box;
}

ObjectBox Solid(double x, double y, double z, double heading, double length = 4.0,
                double width = 2.0, double height = 1.5) {
  ObjectBox box;
  box.box3d = ObjectBox::Box3d{height, width, length, {x, y, z}, heading};
  return box;
}

TEST(BoxOverlap, InTheImage) {
  const ObjectBox a = ImageBox(0, 0, 10, 10);
  const ObjectBox b = ImageBox(5, 0, 15, 10);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion(BoxSpace::kImage, a, b), 50.0 / 150.0);
  EXPECT_DOUBLE_EQ(ShareInside(ImageBox(0, 0, 10, 10), ImageBox(5, 5, 100, 100)), 0.25);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kImage, a, ImageBox(10, 0, 20, 10)), 0.0);
  EXPECT_EQ(ShareInside(ImageBox(3, 3, 3, 3), a), 0.0);
}

// At heading 0 the length lies along x.
TEST(BoxOverlap, LengthIsAlongTheHeading) {
  const ObjectBox a = Solid(0, 0, 10, 0.0);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(2, 0, 10, 0.0)), 1.0 / 3.0,
              1e-12);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(0, 0, 11, 0.0)), 1.0 / 3.0,
              1e-12);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(0, 0, 12.5, 0.0)), 0.0);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(0, 0, 10, kPi / 2)), 4.0 / 12.0,
              1e-12);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(0, 0, 10, kPi)), 1.0, 1e-12);
}

// Two equal squares, one rotated by 45 degrees: their intersection is a regular octagon.
TEST(BoxOverlap, OfRotatedSquares) {
  const double octagon = 2.0 * (std::sqrt(2.0) - 1.0);
  const ObjectBox a = Solid(1, 0, 5, 0.3, 1.0, 1.0);
  const ObjectBox b = Solid(1, 0, 5, 0.3 + kPi / 4, 1.0, 1.0);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, a, b), octagon / (2.0 - octagon), 1e-12);
}

// A box extends upwards from the centre of its bottom face; y points down.
TEST(BoxOverlap, HeightExtendsUpwardsFromTheBottom) {
  const ObjectBox a = Solid(0, 0, 10, 0.7);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kVolume, a, Solid(0, -0.75, 10, 0.7)), 1.0 / 3.0,
              1e-12);
  const ObjectBox taller = Solid(0, 0, 10, 0.7, 4.0, 2.0, 3.0);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kVolume, a, taller), 0.5, 1e-12);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kVolume, a, Solid(0, -1.5, 10, 0.7)), 0.0);
}

TEST(BoxOverlap, WithoutA3dBoxIsZero) {
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kBirdsEye, ImageBox(0, 0, 9, 9), Solid(0, 0, 5, 0)),
            0.0);
}

// Compares with random points: those in both boxes, divided by those in either.
TEST(BoxOverlap, MatchesSampling) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto inside = [](const ObjectBox& box, double x, double z) {
    const double dx = x - box.box3d->bottom_in_camera.x();
    const double dz = z - box.box3d->bottom_in_camera.z();
    const double c = std::cos(box.box3d->heading_rad);
    const double s = std::sin(box.box3d->heading_rad);
    return std::abs(c * dx - s * dz) < 0.5 * box.box3d->length_m &&
           std::abs(s * dx + c * dz) < 0.5 * box.box3d->width_m;
  };
  for (int trial = 0; trial < 20; ++trial) {
    const ObjectBox a = Solid(uniform(random), 0, uniform(random), 4.0 * uniform(random));
    const ObjectBox b = Solid(uniform(random), 0, uniform(random), 4.0 * uniform(random));
    int both = 0;
    int any = 0;
    for (int i = 0; i < 40'000; ++i) {
      const double x = 4.0 * uniform(random);
      const double z = 4.0 * uniform(random);
      const bool in_a = inside(a, x, z);
      const bool in_b = inside(b, x, z);
      both += in_a && in_b;
      any += in_a || in_b;
    }
    const double overlap = IntersectionOverUnion(BoxSpace::kBirdsEye, a, b);
    EXPECT_NEAR(overlap, static_cast<double>(both) / any, 0.02);
    EXPECT_NEAR(overlap, IntersectionOverUnion(BoxSpace::kBirdsEye, b, a), 1e-12);
  }
}

// Coinciding sides clip nothing.
TEST(BoxOverlap, OfABoxWithItselfIsOne) {
  const ObjectBox a = Solid(0, 0, 0, 0.0);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kBirdsEye, a, a), 1.0);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kVolume, a, a), 1.0);
  const ObjectBox inside = Solid(0, 0, 0.5, 0.0, 4.0, 1.0);  // along one of its sides
  EXPECT_DOUBLE_EQ(IntersectionOverUnion(BoxSpace::kBirdsEye, a, inside), 0.5);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(4, 0, 0, 0.0)), 0.0);
}

TEST(BoxOverlap, OfARotatedBoxInsideIsTheRatioOfAreas) {
  const ObjectBox large = Solid(1, 0, 2, 0.4, 8.0, 8.0);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, large, Solid(1.5, 0, 2.5, 1.1)),
              8.0 / 64.0, 1e-12);
}

// A box with swapped sides has no area.
TEST(BoxOverlap, OfBoxesWithSwappedSidesIsZero) {
  const ObjectBox a = ImageBox(0, 0, 10, 10);
  EXPECT_EQ(ShareInside(ImageBox(8, 2, 4, 6), a), 0.0);
  EXPECT_EQ(ShareInside(ImageBox(8, 6, 4, 2), a), 0.0);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kImage, a, ImageBox(0, 20, 10, 30)), 0.0);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion(BoxSpace::kImage, a, ImageBox(2, 3, 6, 8)), 0.2);
  EXPECT_NEAR(ShareInside(ImageBox(0.2, 0.2, 0.6, 0.6), ImageBox(0.4, 0, 9, 9)), 0.5, 1e-12);
}

}  // namespace
}  // namespace cvo::box_overlap_test
