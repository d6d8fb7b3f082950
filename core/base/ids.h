// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>

namespace cvo {

// An integer that cannot be mixed up with another kind of id. Ordered, so that ties break by id.
template <typename Tag>
struct StrongId {
  std::int64_t value = -1;

  constexpr bool valid() const { return value >= 0; }
  friend constexpr auto operator<=>(const StrongId&, const StrongId&) = default;
};

using FrameId = StrongId<struct FrameTag>;
using LandmarkId = StrongId<struct LandmarkTag>;
using ClusterId = StrongId<struct ClusterTag>;  // moving bodies count from 1

// A body of the world, by the number that a giver of labels has for it: 0 the static scene, invalid
// where it is not known.
using BodyId = StrongId<struct BodyTag>;

// The static scene, q = 0 of the paper. An invalid id is a landmark of no body (outlier class).
inline constexpr ClusterId kStaticScene{0};
inline constexpr BodyId kStaticBody{0};

}  // namespace cvo
