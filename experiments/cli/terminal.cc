// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ostream>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"

namespace cvo {
namespace {

// "48 s", "3:07 min", "2:05 h".
std::string Duration(double seconds) {
  const long whole = std::lround(std::ceil(seconds));
  if (whole < 60) return StrCat(whole, " s");
  const bool hours = whole >= 6000;
  const long units = hours ? whole / 60 : whole;
  return StrCat(units / 60, units % 60 < 10 ? ":0" : ":", units % 60, hours ? " h" : " min");
}

// A global, because a signal handler can access nothing else.
volatile std::sig_atomic_t stop_requested = 0;

void NoteSignal(int) { stop_requested = 1; }

void Handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

void TextTable::Add(std::vector<std::string> row) {
  Require(row.size() == rows_.front().size(), "TextTable::Add: one cell per column");
  rows_.push_back(std::move(row));
}

std::vector<std::string> TextTable::Lines() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const std::vector<std::string>& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], Width(row[i]));
  }
  std::vector<std::string> lines;
  for (const std::vector<std::string>& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(widths[i] - Width(row[i]) + 2, ' ');
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

void TextTable::Print(std::ostream& out) const {
  for (const std::string& line : Lines()) out << line << '\n';
}

std::string ReadableNumber(double value) { return FormatGeneral(value, 4); }

std::string FrameRateText(double frames_per_s) {
  const std::string number = ReadableNumber(frames_per_s);
  return number + (number == "1" ? " frame/s" : " frames/s");
}

Progress::Progress(std::size_t total, bool quiet, Clock::time_point start, const ProgressUnit& unit)
    : total_(total),
      unit_(unit),
      style_(quiet                     ? Style::kNone
             : ::isatty(STDERR_FILENO) ? Style::kBar
                                       : Style::kLines),
      start_(start),
      shown_(start_) {}

Progress::~Progress() {
  if (style_ == Style::kBar) std::fputs("\r\033[K", stderr);
}

void Progress::Report(std::size_t done) {
  if (style_ == Style::kBar) PrintBar(done);
  if (style_ == Style::kLines) PrintLine(done);
}

void Progress::Note(const std::string& line) const {
  std::fprintf(stderr, "%s%s\n", style_ == Style::kBar ? "\r\033[K" : "", Printable(line).c_str());
}

std::string Progress::Text(std::size_t done) const {
  const std::string counts = StrCat(done, "/", total_, " ", unit_.name);
  if (done == 0) return counts;
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = static_cast<double>(done) / std::max(elapsed_s, 1e-9);
  return StrCat(counts, "  ", FormatFixed(rate * unit_.per_s, 1), " ", unit_.rate, "  ",
                Duration(static_cast<double>(total_ - done) / rate), " left");
}

void Progress::PrintBar(std::size_t done) {
  const Clock::time_point now = Clock::now();
  if (now - shown_ < std::chrono::milliseconds(100) && done > 0 && done < total_) return;
  shown_ = now;
  constexpr std::size_t kWidth = 30;
  const std::size_t filled = kWidth * done / total_;
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r[%s] %s\033[K", bar.c_str(), Text(done).c_str());
  std::fflush(stderr);
}

void Progress::PrintLine(std::size_t done) {
  const std::size_t tenths = 10 * done / total_;
  if (tenths == shown_tenths_) return;
  shown_tenths_ = tenths;
  std::fprintf(stderr, "%3zu %%  %s\n", 100 * done / total_, Text(done).c_str());
}

StopSignal::StopSignal() {
  stop_requested = 0;
  Handle(NoteSignal);
}

StopSignal::~StopSignal() { Handle(SIG_DFL); }

bool StopSignal::Requested() const { return stop_requested != 0; }

}  // namespace cvo
