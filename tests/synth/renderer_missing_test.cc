// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_message.h"
#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

TEST(RendererMissing, ReportsTheMissingRenderer) {
  const auto says_so = testing::HasSubstr("synthetic scenes: found no OSMesa in this build");
  EXPECT_THAT(ErrorMessage([] { Renderer renderer(World(), 1); }), says_so);
  EXPECT_THAT(ErrorMessage([] { FindRendererVersion(); }), says_so);
}

}  // namespace
}  // namespace cvo::synth
