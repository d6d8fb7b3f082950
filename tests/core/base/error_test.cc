// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"

#include <gtest/gtest.h>

#include "core/base/ids.h"
#include "core/base/message.h"
#include "core/base/stage_times.h"

namespace cvo {
namespace {

TEST(Error, MessageNamesPlaceFoundAndExpected) {
  try {
    ThrowError("calib.txt line 3", "2 numbers", "12");
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "calib.txt line 3: found 2 numbers, expected 12");
  }
}

TEST(Error, MessageLengthIsLimited) {
  const std::string much(400'000, 'x');
  try {
    ThrowError("calib.txt", much, "12");
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_LE(message.size(), kMaxMessage);
    EXPECT_TRUE(message.starts_with("calib.txt: found xxx"));
    EXPECT_TRUE(message.ends_with("x, expected 12"));
  }
  EXPECT_EQ(Shortened("short"), "short");
}

TEST(Error, RequireThrowsInEveryBuildType) {
  EXPECT_NO_THROW(Require(true, "fine"));
  EXPECT_THROW(Require(false, "broken"), Error);
}

TEST(StrCat, FormatsLikeAStream) {
  EXPECT_EQ(StrCat("a", 1, ' ', std::string("b")), "a1 b");
  EXPECT_EQ(StrCat(0.1, " ", 200000.0, " ", 1e300), "0.1 200000 1e+300");
  EXPECT_EQ(StrCat(1234567.5), "1234567.5");
}

TEST(StrongId, OrdersByValueAndReportsValidity) {
  EXPECT_FALSE(FrameId{}.valid());
  EXPECT_TRUE(FrameId{0}.valid());
  EXPECT_LT(LandmarkId{2}, LandmarkId{10});
  EXPECT_EQ(LandmarkId{2}, LandmarkId{2});
  static_assert(!std::is_convertible_v<FrameId, LandmarkId>);
}

TEST(ScopedStage, AddsTimeToItsStage) {
  StageTimes times;
  { const ScopedStage stage(times, "solve"); }
  const double once = times.at("solve");
  EXPECT_GE(once, 0.0);
  { const ScopedStage stage(times, "solve"); }
  EXPECT_GE(times.at("solve"), once);
  EXPECT_EQ(times.size(), 1u);
}

}  // namespace
}  // namespace cvo
