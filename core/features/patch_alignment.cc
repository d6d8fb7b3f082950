// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/patch_alignment.h"

#include <cmath>
#include <vector>

namespace cvo {
namespace {

// A rectangle of an image, sampled bilinearly on a grid of step 1.
struct Samples {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  const float* Row(int y) const { return &values[static_cast<std::size_t>(y) * width]; }
};

// (u, v): the upper left sample.
bool SampleGrid(const cv::Mat& image, double u, double v, int width, int height, Samples& samples) {
  const int x = static_cast<int>(std::floor(u));
  const int y = static_cast<int>(std::floor(v));
  if (x < 0 || y < 0 || x + width >= image.cols || y + height >= image.rows) return false;
  const float fu = static_cast<float>(u - x);
  const float fv = static_cast<float>(v - y);
  samples.width = width;
  samples.height = height;
  samples.values.resize(static_cast<std::size_t>(width) * height);
  for (int i = 0; i < height; ++i) {
    const std::uint8_t* row = image.ptr<std::uint8_t>(y + i) + x;
    const std::uint8_t* next = image.ptr<std::uint8_t>(y + i + 1) + x;
    float* out = &samples.values[static_cast<std::size_t>(i) * width];
    for (int j = 0; j < width; ++j) {
      const float top = static_cast<float>(row[j]) + fu * static_cast<float>(row[j + 1] - row[j]);
      const float bottom =
          static_cast<float>(next[j]) + fu * static_cast<float>(next[j + 1] - next[j]);
      out[j] = top + fv * (bottom - top);
    }
  }
  return true;
}

// Mean squared difference of the patch and the strip's columns from `shift` on, without the means.
float Cost(const Samples& patch, const Samples& strip, int shift) {
  float sum = 0.0F;
  float squares = 0.0F;
  for (int y = 0; y < patch.height; ++y) {
    const float* a = patch.Row(y);
    const float* b = strip.Row(y) + shift;
    for (int x = 0; x < patch.width; ++x) {
      const float difference = a[x] - b[x];
      sum += difference;
      squares += difference * difference;
    }
  }
  const float n = static_cast<float>(patch.values.size());
  return (squares - sum * sum / n) / n;
}

}  // namespace

std::optional<PatchMatch> AlignPatch(const cv::Mat& left, const cv::Mat& right,
                                     const PatchQuery& query) {
  const int side = 2 * query.patch_radius + 1;
  const int shifts = 2 * query.search_radius + 1;
  // Both patches start at the same fraction of a pixel: interpolation smooths them alike.
  const double whole_disparity = std::round(query.u_left - query.u_right);
  const double u_left = query.u_left - query.patch_radius;
  const double u_right = u_left - whole_disparity - query.search_radius;
  const double v_left = query.v_left - query.patch_radius;
  const double v_right = query.v_right - query.patch_radius;
  Samples patch;
  Samples strip;
  if (!SampleGrid(left, u_left, v_left, side, side, patch) ||
      !SampleGrid(right, u_right, v_right, side + shifts - 1, side, strip)) {
    return std::nullopt;
  }
  std::vector<float> costs;
  for (int shift = 0; shift < shifts; ++shift) costs.push_back(Cost(patch, strip, shift));
  int best = 0;
  for (int shift = 1; shift < shifts; ++shift) {
    if (costs[shift] < costs[best]) best = shift;
  }
  if (best == 0 || best == shifts - 1) return std::nullopt;
  const double before = costs[best - 1];
  const double after = costs[best + 1];
  const double curvature = before + after - 2.0 * costs[best];
  if (!(curvature > 0.0)) return std::nullopt;
  const double delta = 0.5 * (before - after) / curvature;
  return PatchMatch{query.u_left - whole_disparity - query.search_radius + best + delta,
                    costs[best]};
}

}  // namespace cvo
