// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace cvo::reports {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Rgb&) const = default;
};

inline constexpr Rgb kStaticColor{205, 205, 205};
inline constexpr Rgb kOutlierColor{255, 255, 255};
inline constexpr Rgb kDetectionColor{255, 255, 255};

inline constexpr std::size_t kClusterColors = 16;

// The colour of an id is the same in every frame, run and report. The first seven colours remain
// distinguishable with red-green colour blindness (after Okabe and Ito). See ApartColors for ids
// that share a colour.
Rgb ClusterColor(std::int64_t id);

// Black or white, whichever is more legible on the background.
Rgb TextColorOn(Rgb background);

}  // namespace cvo::reports
