// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/task_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace cvo {
namespace {

using testing::ElementsAre;

class TaskPoolOn : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Threads, TaskPoolOn, testing::Values(1, 2, 3, 4));

TEST_P(TaskPoolOn, WaitReturnsAfterTheTask) {
  TaskPool pool(GetParam());
  for (int i = 0; i < 1000; ++i) {
    int value = 0;
    const TaskPool::Ticket ticket = pool.Submit([&value] { value = 7; });
    pool.Wait(ticket);
    ASSERT_EQ(value, 7);
  }
}

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

TEST_P(TaskPoolOn, TicketsMayBeAwaitedInAnyOrder) {
  TaskPool pool(GetParam());
  std::vector<int> done(50, 0);
  std::vector<TaskPool::Ticket> tickets;
  for (int i = 0; i < 50; ++i) tickets.push_back(pool.Submit([&done, i] { done[i] = i; }));
  for (int i = 49; i >= 0; --i) {
    pool.Wait(tickets[i]);
    EXPECT_EQ(done[i], i);
  }
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
}  // namespace cvo
