// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cvo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct InnerOptions {
  double ratio = 0.5;
  bool flag = true;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("ratio", self.ratio, {"1", 0.0, 1.0, "a ratio", "test"});
    visit.Field("flag", self.flag, {"1", 0, 1, "a switch", "test"});
  }
};

struct OuterOptions {
  int count = 5;
  InnerOptions inner;
  InnerOptions other;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("count", self.count, {"1", 1, 10, "a count", "test"});
    visit.Group("inner", self.inner);
    visit.Group("other", self.other);
  }
};

static_assert(OptionsStruct<OuterOptions>);
static_assert(!OptionsStruct<int>);

std::string RangeError(const OuterOptions& options) {
  try {
    CheckRanges(options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Options, LeavesHaveDottedPathsInOrder) {
  std::vector<std::string> paths;
  const OuterOptions options;
  VisitLeaves(options, [&](const std::string& path, const auto&, const FieldInfo&) {
    paths.push_back(path);
  });
  EXPECT_THAT(paths,
              ElementsAre("count", "inner.ratio", "inner.flag", "other.ratio", "other.flag"));
}

TEST(Options, LeavesCanBeWritten) {
  OuterOptions options;
  VisitLeaves(options, [](const std::string& path, auto& value, const FieldInfo&) {
    if (path == "other.ratio") value = static_cast<std::decay_t<decltype(value)>>(1);
  });
  EXPECT_EQ(options.other.ratio, 1.0);
  EXPECT_EQ(options.inner.ratio, 0.5);
}

TEST(Options, DefaultsAndLimitsAreInRange) {
  OuterOptions options;
  EXPECT_EQ(RangeError(options), "");
  options.count = 10;
  options.inner.ratio = 0.0;
  EXPECT_EQ(RangeError(options), "");
}

TEST(Options, RangeErrorNamesPathValueAndRange) {
  OuterOptions options;
  options.other.ratio = 1.5;
  EXPECT_EQ(RangeError(options), "option other.ratio: found 1.5, expected a value in [0, 1]");
}

TEST(Options, RangeErrorShowsTheValueInFullPrecision) {
  OuterOptions options;
  options.inner.ratio = 1.0000001;
  EXPECT_THAT(RangeError(options), HasSubstr("found 1.0000001,"));
}

TEST(Options, NotANumberAndInfinityAreOutOfRange) {
  OuterOptions options;
  options.inner.ratio = std::nan("");
  EXPECT_THAT(RangeError(options), HasSubstr("inner.ratio: found nan"));
  options.inner.ratio = std::numeric_limits<double>::infinity();
  EXPECT_THAT(RangeError(options), HasSubstr("inner.ratio: found inf"));
}

}  // namespace
}  // namespace cvo
