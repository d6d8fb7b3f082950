// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace cvo {

// Wall time by stage, seconds. Measured alongside the results, and never read by the estimator.
using StageTimes = std::map<std::string, double>;

// Adds the time from its construction to its destruction to times[stage].
class ScopedStage {
 public:
  ScopedStage(StageTimes& times, const char* stage)
      : times_(times), stage_(stage), start_(std::chrono::steady_clock::now()) {}
  ~ScopedStage() {
    times_[stage_] +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  ScopedStage(const ScopedStage&) = delete;
  ScopedStage& operator=(const ScopedStage&) = delete;

 private:
  StageTimes& times_;
  const char* stage_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace cvo
