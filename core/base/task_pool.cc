// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/task_pool.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"

namespace cvo {
namespace {

void JoinAll(std::vector<std::thread>& workers, std::mutex& mutex, bool& stopping,
             std::condition_variable& changed) {
  {
    const std::lock_guard lock(mutex);
    stopping = true;
  }
  changed.notify_all();
  for (std::thread& worker : workers) worker.join();
}

}  // namespace

TaskPool::TaskPool(int threads) {
  Require(threads >= 1, "TaskPool: threads must be at least 1");
  workers_.reserve(static_cast<std::size_t>(threads) - 1);
  try {
    for (int i = 1; i < threads; ++i) workers_.emplace_back([this] { RunWorker(); });
  } catch (const std::exception&) {  // the system cannot start any more threads
    const std::size_t started = workers_.size() + 1;
    JoinAll(workers_, mutex_, stopping_, changed_);
    ThrowError("threads", StrCat(threads), StrCat("at most ", started, ", as many as could start"));
  }
}

TaskPool::~TaskPool() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
  }
  JoinAll(workers_, mutex_, stopping_, changed_);
}

TaskPool::Ticket TaskPool::Submit(std::function<void()> work) {
  auto task = std::make_shared<Task>();
  task->work = std::move(work);
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(task);
  }
  changed_.notify_all();
  return task;
}

void TaskPool::Wait(const Ticket& ticket) {
  std::unique_lock lock(mutex_);
  while (!ticket->done) {
    // Run the awaited task first: the caller may have no use yet for those queued before it.
    const auto own = std::find(waiting_.begin(), waiting_.end(), ticket);
    if (own != waiting_.end()) {
      waiting_.erase(own);
      RunTask(ticket, lock);
    } else if (!waiting_.empty()) {
      const Ticket other = waiting_.front();
      waiting_.pop_front();
      RunTask(other, lock);
    } else {
      changed_.wait(lock);
    }
  }
  if (ticket->error) std::rethrow_exception(ticket->error);
}

void TaskPool::ParallelFor(int count, const std::function<void(int)>& work) {
  std::vector<Ticket> tickets;
  tickets.reserve(static_cast<std::size_t>(std::max(count, 0)));
  for (int i = 0; i < count; ++i) tickets.push_back(Submit([&work, i] { work(i); }));
  std::exception_ptr first_error;
  for (const Ticket& ticket : tickets) {
    try {
      Wait(ticket);
    } catch (...) {
      if (!first_error) first_error = std::current_exception();
    }
  }
  if (first_error) std::rethrow_exception(first_error);
}

void TaskPool::RunWorker() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (stopping_) return;
    const Ticket task = waiting_.front();
    waiting_.pop_front();
    RunTask(task, lock);
  }
}

void TaskPool::RunTask(const Ticket& task, std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  std::exception_ptr error;
  try {
    task->work();
  } catch (...) {
    error = std::current_exception();
  }
  task->work = nullptr;
  lock.lock();
  task->error = error;
  task->done = true;
  changed_.notify_all();
}

}  // namespace cvo
