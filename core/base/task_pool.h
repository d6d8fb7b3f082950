// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace cvo {

// Runs tasks on `threads` threads in total: threads - 1 workers and the thread that waits. With one
// thread, a task runs when it is waited for, so results must not depend on the order in which tasks
// run.
class TaskPool {
  struct Task;

 public:
  // Handle of a submitted task. Call Wait on it exactly once.
  using Ticket = std::shared_ptr<Task>;

  explicit TaskPool(int threads);
  // Drops tasks that have not started and waits for those that have.
  ~TaskPool();
  TaskPool(const TaskPool&) = delete;
  TaskPool& operator=(const TaskPool&) = delete;

  Ticket Submit(std::function<void()> work);
  // Returns when the task has ended. If no worker has taken it yet, runs it on the calling thread;
  // otherwise runs other tasks in the meantime. Rethrows the exception of the task.
  void Wait(const Ticket& ticket);
  // Runs work(0) ... work(count - 1) in any order and returns when all have ended. Rethrows the
  // exception with the lowest index.
  void ParallelFor(int count, const std::function<void(int)>& work);

 private:
  struct Task {
    std::function<void()> work;
    std::exception_ptr error;
    bool done = false;
  };

  void RunWorker();
  void RunTask(const Ticket& task, std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Ticket> waiting_;
  bool stopping_ = false;
  std::vector<std::thread> workers_;
};

}  // namespace cvo
