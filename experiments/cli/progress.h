// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>

namespace cvo {

// How far a run has come, on stderr: a bar with frame rate and time left on a terminal, otherwise a
// line every tenth of the way.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  // `start`: when the work began, where that was before its amount was known.
  // `unit`: what is counted.
  Progress(std::size_t total, bool quiet, Clock::time_point start = Clock::now(),
           const char* unit = "frames");
  ~Progress();  // takes the bar off the terminal
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void Report(std::size_t done);

 private:
  enum class Style { kNone, kBar, kLines };

  void PrintBar(std::size_t done, double rate);
  void PrintLine(std::size_t done, double rate);

  std::size_t total_;
  const char* unit_;
  Style style_;
  Clock::time_point start_;
  Clock::time_point shown_;
  std::size_t shown_tenths_ = 0;
};

}  // namespace cvo
