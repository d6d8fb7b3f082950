// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/features/orb/orb.h"
#include "experiments/datasets/plausibility.h"

// Images compared by their corners, matched by appearance alone, wherever they are.
namespace cvo {

using Corners = std::vector<OrbKeypoint>;

// What is kept of an image: its corners and a smaller copy; empty if it cannot be decoded.
struct SeenImage {
  Corners corners;
  cv::Mat small;
  double brightest = 0.0;
};

// Looks at the left (side 0) or right image of a frame.
SeenImage See(const Sequence& sequence, std::size_t index, int side);

// For each corner of `from`, the one of `to` if each is clearly the most similar to the other; or
// null.
std::vector<const OrbKeypoint*> MatchAnywhere(const Corners& from, const Corners& to);

inline Eigen::Vector2d PixelOf(const OrbKeypoint& corner) { return {corner.u_px, corner.v_px}; }

// Fewer matches tell nothing.
inline constexpr std::size_t kFewestMatches = 20;

// Compares the corners of a left image with their partners in the right one, null where there is
// none. Empty if there are too few.
std::optional<PairCheck> CheckPair(const Corners& left,
                                   const std::vector<const OrbKeypoint*>& right);

}  // namespace cvo
