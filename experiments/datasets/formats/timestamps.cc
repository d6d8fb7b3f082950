// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/timestamps.h"

#include <chrono>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

constexpr std::string_view kShape = "dddd-dd-dd dd:dd:dd.ddddddddd";

bool HasShape(std::string_view text) {
  if (text.size() != kShape.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool digit = text[i] >= '0' && text[i] <= '9';
    if (kShape[i] == 'd' ? !digit : text[i] != kShape[i]) return false;
  }
  return true;
}

void CheckIncreasing(const TextFile& file, const std::vector<std::int64_t>& times) {
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] <= times[i - 1]) {
      ThrowError(file.Where(i), Quoted(file.line(i)),
                 "a time after that of the line before, " + Quoted(file.line(i - 1)));
    }
  }
}

std::string_view TrimEnd(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

}  // namespace

std::optional<std::int64_t> ParseDateTimeNs(std::string_view text) {
  if (!HasShape(text)) return std::nullopt;
  const auto number = [&](std::size_t begin, std::size_t count) {
    return *ParseInteger(text.substr(begin, count));
  };
  const std::chrono::year_month_day date(std::chrono::year(static_cast<int>(number(0, 4))),
                                         std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                         std::chrono::day(static_cast<unsigned>(number(8, 2))));
  const std::int64_t hour = number(11, 2), minute = number(14, 2), second = number(17, 2);
  // An int64 in ns covers the years 1678 to 2261.
  if (!date.ok() || hour > 23 || minute > 59 || second > 59 || number(0, 4) < 1678 ||
      number(0, 4) > 2261) {
    return std::nullopt;
  }
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return (((days * 24 + hour) * 60 + minute) * 60 + second) * 1'000'000'000 + number(20, 9);
}

std::vector<std::int64_t> ReadDateTimes(const std::filesystem::path& path) {
  const TextFile file(path);
  std::vector<std::int64_t> times;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const std::optional<std::int64_t> time = ParseDateTimeNs(TrimEnd(file.line(i)));
    if (!time) {
      ThrowError(file.Where(i), Quoted(file.line(i)), "a time YYYY-MM-DD HH:MM:SS.nnnnnnnnn");
    }
    times.push_back(*time);
  }
  CheckIncreasing(file, times);
  return times;
}

std::vector<std::int64_t> ReadSecondsTimes(const std::filesystem::path& path) {
  const TextFile file(path);
  std::vector<std::int64_t> times;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i);
    row.ExpectColumns(1, "a time in seconds");
    times.push_back(row.SecondsNs(0));
  }
  CheckIncreasing(file, times);
  return times;
}

std::vector<std::int64_t> NominalTimes(std::size_t frames, double rate_hz) {
  std::vector<std::int64_t> times;
  for (std::size_t i = 0; i < frames; ++i) {
    times.push_back(std::llround(1e9 * static_cast<double>(i) / rate_hz));
  }
  return times;
}

}  // namespace cvo
