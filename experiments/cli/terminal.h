// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace cvo {

// A table of text, with columns aligned by spaces.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header) : rows_{std::move(header)} {}

  // Appends a row, which must have as many cells as the header.
  void Add(std::vector<std::string> row);
  // Returns one line per row, the header first.
  std::vector<std::string> Lines() const;
  void Print(std::ostream& out) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

// A number for display, with four significant digits.
std::string ReadableNumber(double value);

// "1 frame/s", "12.5 frames/s".
std::string FrameRateText(double frames_per_s);

// What is counted, and the unit of its rate: `per_s` converts to it from 1/s.
struct ProgressUnit {
  const char* name;
  const char* rate;
  double per_s;
};
inline constexpr ProgressUnit kFrames{"frames", "frames/s", 1.0};
inline constexpr ProgressUnit kJobs{"jobs", "jobs/min", 60.0};
inline constexpr ProgressUnit kScenes{"scenes", "scenes/min", 60.0};
inline constexpr ProgressUnit kSequences{"sequences", "sequences/min", 60.0};
inline constexpr ProgressUnit kPlanned{"jobs planned", "jobs/s", 1.0};

// Shows progress on stderr: on a terminal, a bar with the rate and the time left; otherwise a line
// after every tenth of the work.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  // `start`: when the work began, if that was before its amount was known.
  Progress(std::size_t total, bool quiet, Clock::time_point start = Clock::now(),
           const ProgressUnit& unit = kFrames);
  ~Progress();  // erases the bar
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void Report(std::size_t done);
  // Prints one line, even if quiet. The bar reappears with the next report.
  void Note(const std::string& line) const;

 private:
  enum class Style { kNone, kBar, kLines };

  void PrintBar(std::size_t done);
  void PrintLine(std::size_t done);
  // "3/8 jobs  2.0 jobs/min  2:30 min left"
  std::string Text(std::size_t done) const;

  std::size_t total_;
  ProgressUnit unit_;
  Style style_;
  Clock::time_point start_;
  Clock::time_point shown_;
  std::size_t shown_tenths_ = 0;
};

// Exit code of a command that was stopped by SIGINT or SIGTERM.
inline constexpr int kInterrupted = 130;

// While an instance exists, the first SIGINT and the first SIGTERM are only recorded; a second
// signal of the same kind ends the program.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  bool Requested() const;
};

}  // namespace cvo
