// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/files/images/float_tiff.h"

namespace cvo::test {

// Expects that a cut file is refused at every length, and that one with a changed byte is either
// refused or read as an image. Depths may change.
inline void ExpectDamageIsReadOrRefused(const std::string& tiff) {
  ASSERT_TRUE(DecodeFloatTiff(tiff).has_value());
  for (std::size_t i = 0; i < tiff.size(); ++i) {
    EXPECT_FALSE(DecodeFloatTiff(tiff.substr(0, i)).has_value()) << i;
    std::string damaged = tiff;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    const auto image = DecodeFloatTiff(damaged);
    if (image) {
      EXPECT_EQ(static_cast<int>(image->values.size()), image->width_px * image->height_px);
    }
  }
}

}  // namespace cvo::test
