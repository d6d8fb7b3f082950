// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace cvo {

// The largest side of an image that is read.
inline constexpr std::uint32_t kMaxSide_px = 1 << 15;

// Whether so many bytes, compressed by deflate at most, can be an image of this size. Decoders
// refuse others before they allocate memory for them.
constexpr bool CanHold(std::size_t compressed_bytes, std::size_t image_bytes) {
  constexpr std::size_t kMaxRatio = 1032;  // of deflate
  return image_bytes / kMaxRatio <= compressed_bytes;
}

}  // namespace cvo
