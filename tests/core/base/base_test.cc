// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/options.h"
#include "core/base/rng.h"
#include "core/base/stage_times.h"
#include "core/base/task_pool.h"

namespace cvo::base_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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

TEST(ScopedStage, AddsTimeToItsStage) {
  StageTimes times;
  { const ScopedStage stage(times, "solve"); }
  const double once = times.at("solve");
  EXPECT_GE(once, 0.0);
  { const ScopedStage stage(times, "solve"); }
  EXPECT_GE(times.at("solve"), once);
  EXPECT_EQ(times.size(), 1u);
}

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

TEST(Options, NotANumberAndInfinityAreOutOfRange) {
  OuterOptions options;
  options.inner.ratio = std::nan("");
  EXPECT_THAT(RangeError(options), HasSubstr("inner.ratio: found nan"));
  options.inner.ratio = std::numeric_limits<double>::infinity();
  EXPECT_THAT(RangeError(options), HasSubstr("inner.ratio: found inf"));
}

std::vector<std::uint64_t> Draw(Rng rng, int count) {
  std::vector<std::uint64_t> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(rng.NextU64());
  return numbers;
}

// The values are from an independent implementation of SplitMix64, FNV-1a and xoshiro256**. If they
// change, so does every seeded result.
TEST(Rng, GoldenValues) {
  EXPECT_THAT(Draw(Rng(1, "ransac"), 3),
              ElementsAre(0x732B2FDE8EC4671u, 0x2F745CAC8CA43757u, 0x6C4C54E44526B3BFu));
  EXPECT_THAT(Draw(Rng(1, "scene"), 3),
              ElementsAre(0x230B6A6EF5CAD983u, 0x68E943285E79E105u, 0x968D51489E007525u));
  EXPECT_THAT(Draw(Rng(2, "ransac"), 3),
              ElementsAre(0xF0C1D37E20812EADu, 0x37C6C327CB0FB012u, 0x10B61FE89DE01A70u));
  Rng rng(1, "ransac");
  EXPECT_EQ(rng.Uniform(), 0.028117358197889963);
  EXPECT_EQ(rng.Uniform(), 0.1853692933333526);
}

TEST(Rng, NormalHasItsMoments) {
  Rng rng(4, "normal");
  const int count = 200000;
  std::array<double, 5> moments{};
  for (int i = 0; i < count; ++i) {
    const double x = rng.Normal();
    for (int k = 1; k <= 4; ++k) moments[k] += std::pow(x, k) / count;
  }
  EXPECT_NEAR(moments[1], 0.0, 0.01);
  EXPECT_NEAR(moments[2], 1.0, 0.02);
  EXPECT_NEAR(moments[3], 0.0, 0.05);
  EXPECT_NEAR(moments[4], 3.0, 0.15);
}

TEST(Rng, UniformIntCoversItsRangeEvenly) {
  Rng rng(6, "int");
  std::array<int, 7> counts{};
  const int draws = 70000;
  for (int i = 0; i < draws; ++i) ++counts[rng.UniformInt(counts.size())];
  for (const int count : counts) EXPECT_NEAR(count, draws / 7, 500);  // five standard errors
}

class TaskPoolOn : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Threads, TaskPoolOn, testing::Values(1, 2, 3, 4));

TEST_P(TaskPoolOn, ParallelForRunsEachIndexOnce) {
  TaskPool pool(GetParam());
  std::vector<int> runs(5000, 0);
  pool.ParallelFor(static_cast<int>(runs.size()), [&runs](int i) { ++runs[i]; });
  EXPECT_EQ(runs, std::vector<int>(5000, 1));
  pool.ParallelFor(0, [](int) { FAIL(); });
  pool.ParallelFor(-1, [](int) { FAIL(); });
}

TEST_P(TaskPoolOn, TasksMayWaitForTasks) {
  TaskPool pool(GetParam());
  std::vector<int> sums(20, 0);
  pool.ParallelFor(20, [&](int i) {
    std::vector<int> parts(30, 0);
    pool.ParallelFor(30, [&](int j) {
      const TaskPool::Ticket inner = pool.Submit([&parts, i, j] { parts[j] = i * j; });
      pool.Wait(inner);
    });
    sums[i] = std::accumulate(parts.begin(), parts.end(), 0);
  });
  for (int i = 0; i < 20; ++i) EXPECT_EQ(sums[i], i * 29 * 30 / 2);
}

TEST_P(TaskPoolOn, WaitRethrowsAndThePoolKeepsRunning) {
  TaskPool pool(GetParam());
  const TaskPool::Ticket bad = pool.Submit([] { throw Error("broken"); });
  const TaskPool::Ticket good = pool.Submit([] {});
  EXPECT_THROW(pool.Wait(bad), Error);
  EXPECT_NO_THROW(pool.Wait(good));
}

TEST_P(TaskPoolOn, ParallelForRethrowsTheFirstErrorByIndexAfterAllHaveEnded) {
  TaskPool pool(GetParam());
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::atomic<int> ended = 0;
    try {
      pool.ParallelFor(40, [&ended](int i) {
        ++ended;
        if (i % 10 == 3) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "3");
    }
    EXPECT_EQ(ended, 40);
  }
}

TEST_P(TaskPoolOn, DestructorDropsQueuedTasksAndFinishesStartedOnes) {
  std::atomic<int> started = 0;
  std::atomic<int> ended = 0;
  {
    TaskPool pool(GetParam());
    for (int i = 0; i < 2000; ++i) {
      pool.Submit([&] {
        ++started;
        ++ended;
      });
    }
  }
  EXPECT_EQ(started, ended);
  EXPECT_LE(ended, 2000);
  if (GetParam() == 1) {
    EXPECT_EQ(started, 0);
  }
}

// Without worker threads, Wait itself runs the awaited task first and leaves the others queued.
TEST(TaskPool, OneThreadRunsTheAwaitedTaskOnTheCaller) {
  TaskPool pool(1);
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<int> order;
  const TaskPool::Ticket first = pool.Submit([&] { order.push_back(1); });
  const TaskPool::Ticket second = pool.Submit([&] {
    order.push_back(2);
    EXPECT_EQ(std::this_thread::get_id(), caller);
  });
  EXPECT_TRUE(order.empty());
  pool.Wait(second);
  pool.Wait(first);
  EXPECT_THAT(order, ElementsAre(2, 1));
}

// Each of two tasks waits for the other to start, so this ends only if both run concurrently.
TEST(TaskPool, TwoThreadsRunTwoTasksConcurrently) {
  TaskPool pool(2);
  std::atomic<int> arrived = 0;
  pool.ParallelFor(2, [&arrived](int) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  EXPECT_EQ(arrived, 2);
}

TEST(TaskPool, NeedsAThread) {
  EXPECT_THROW(TaskPool(0), Error);
  EXPECT_THROW(TaskPool(-2), Error);
}

}  // namespace
}  // namespace cvo::base_test
