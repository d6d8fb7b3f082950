// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>

namespace cvo {

// An integer id that cannot be confused with ids of another kind. Ordered, so that ties can be
// broken by id.
template <typename Tag>
struct StrongId {
  std::int64_t value = -1;

  constexpr bool valid() const { return value >= 0; }
  friend constexpr auto operator<=>(const StrongId&, const StrongId&) = default;
};

using FrameId = StrongId<struct FrameTag>;
using LandmarkId = StrongId<struct LandmarkTag>;
using ClusterId = StrongId<struct ClusterTag>;  // ids of moving clusters start at 1

// A body in the world, by its number in external labels. 0 is the static scene; invalid means
// unknown.
using BodyId = StrongId<struct BodyTag>;

// The static scene, q = 0 in the paper. A landmark with an invalid id belongs to no cluster
// (outlier class).
inline constexpr ClusterId kStaticScene{0};
inline constexpr BodyId kStaticBody{0};

}  // namespace cvo
