// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "experiments/datasets/sequence.h"

namespace cvo {

// The space in which the overlap of two boxes is measured: the image, the ground plane (x-z of
// rectified camera 0), or 3D.
enum class BoxSpace { kImage, kBirdsEye, kVolume };
constexpr std::array<const char*, 3> EnumNames(BoxSpace) { return {"2d", "bv", "3d"}; }

// Intersection over union, in [0, 1]; 0 if a box has no extent in that space. On the ground plane,
// boxes are rectangles of length x width rotated by their heading. Their height extends upwards
// (-y) from the centre of the bottom face.
double IntersectionOverUnion(BoxSpace space, const ObjectBox& a, const ObjectBox& b);

// Intersection in the image over the area of `detection`, in [0, 1].
double ShareInside(const ObjectBox& detection, const ObjectBox& region);

}  // namespace cvo
