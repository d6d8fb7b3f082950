// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace cvo {
namespace {

// "48 s", "3:07 min".
std::string Duration(double seconds) {
  const long whole = std::lround(std::ceil(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + (rest.size() == 1 ? ":0" : ":") + rest + " min";
}

}  // namespace

Progress::Progress(std::size_t total, bool quiet, Clock::time_point start, const char* unit)
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
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = static_cast<double>(done) / std::max(elapsed_s, 1e-9);
  if (style_ == Style::kBar) PrintBar(done, rate);
  if (style_ == Style::kLines) PrintLine(done, rate);
}

void Progress::PrintBar(std::size_t done, double rate) {
  const Clock::time_point now = Clock::now();
  if (now - shown_ < std::chrono::milliseconds(100) && done < total_) return;
  shown_ = now;
  constexpr std::size_t kWidth = 30;
  const std::size_t filled = kWidth * done / total_;
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r[%s] %zu/%zu %s  %.1f %s/s  %s left\033[K", bar.c_str(), done, total_,
               unit_, rate, unit_, Duration(static_cast<double>(total_ - done) / rate).c_str());
  std::fflush(stderr);
}

void Progress::PrintLine(std::size_t done, double rate) {
  const std::size_t tenths = 10 * done / total_;
  if (tenths == shown_tenths_) return;
  shown_tenths_ = tenths;
  std::fprintf(stderr, "%3zu %%  %zu/%zu %s  %.1f %s/s  %s left\n", 100 * done / total_, done,
               total_, unit_, rate, unit_,
               Duration(static_cast<double>(total_ - done) / rate).c_str());
}

}  // namespace cvo
