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

// The static scene, q = 0 of the paper. An invalid id is a landmark of no body (outlier class).
inline constexpr ClusterId kStaticScene{0};

}  // namespace cvo
