// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cvo {

// An axis-aligned rectangle in the left image, px, with pixel centres at integers. It may extend
// beyond the image.
struct ImageBox {
  double left_px = 0.0;
  double top_px = 0.0;
  double right_px = 0.0;   // >= left_px
  double bottom_px = 0.0;  // >= top_px

  double Width() const { return right_px - left_px; }
  double Height() const { return bottom_px - top_px; }
  bool Contains(double u_px, double v_px) const {
    return u_px >= left_px && u_px <= right_px && v_px >= top_px && v_px <= bottom_px;
  }
  // The box with each side moved inwards by `fraction` of its width or height (outwards if < 0).
  ImageBox Shrunk(double fraction) const;
};

// Area of the intersection over area of the union, in [0, 1]; 0 if the boxes do not overlap.
double IntersectionOverUnion(const ImageBox& a, const ImageBox& b);

// Share of the area of `part` that lies inside `whole`, in [0, 1]; 0 if `part` has no area.
double ShareInside(const ImageBox& part, const ImageBox& whole);

}  // namespace cvo
