// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/text/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "core/base/error.h"
#include "core/base/lists.h"

namespace cvo {
namespace {

// Half of the range of int64 (146 years), so that time differences do not overflow.
constexpr std::int64_t kMaxNs = std::numeric_limits<std::int64_t>::max() / 2;

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

template <typename T>
std::optional<T> ParseWhole(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && (IsDigit(text[1]) || text[1] == '.')) {
    text.remove_prefix(1);
  }
  T value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string Formatted(double value, std::chars_format format, int precision) {
  std::array<char, 512> buffer;
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  return std::string(buffer.data(), result.ptr);
}

}  // namespace

std::optional<double> ParseDouble(std::string_view text) {
  const auto value = ParseWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> ParseInteger(std::string_view text) {
  return ParseWhole<std::int64_t>(text);
}

std::optional<int> ParseInt(std::string_view text) { return ParseWhole<int>(text); }

std::optional<std::int64_t> ParseTimeNs(std::string_view text, std::int64_t unit_ns) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  const auto exponent = end == text.size() ? 0 : ParseInt(text.substr(end + 1));
  constexpr int kMostExponent = 400;
  if (!exponent || std::abs(*exponent) > kMostExponent) return std::nullopt;
  std::string digits(text.substr(0, end));
  const std::size_t point = std::min(digits.find('.'), digits.size());
  digits.erase(point, 1);
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), IsDigit)) return std::nullopt;
  // Number of digits before the decimal point in units of 1 ns.
  std::ptrdiff_t whole = static_cast<std::ptrdiff_t>(point) + *exponent;
  for (; unit_ns > 1; unit_ns /= 10) ++whole;
  const auto digit = [&](std::ptrdiff_t i) {
    return i >= 0 && i < std::ssize(digits) ? digits[static_cast<std::size_t>(i)] - '0' : 0;
  };
  std::int64_t magnitude = 0;
  for (std::ptrdiff_t i = 0; i < whole; ++i) {
    if (magnitude > (kMaxNs - digit(i)) / 10) return std::nullopt;
    magnitude = magnitude * 10 + digit(i);
  }
  if (digit(whole) >= 5) ++magnitude;
  return negative ? -magnitude : magnitude;
}

std::string FormatSecondsNs(std::int64_t time_ns) {
  constexpr std::uint64_t kNsPerSecond = 1'000'000'000;
  const auto bits = static_cast<std::uint64_t>(time_ns);
  const std::uint64_t magnitude = time_ns < 0 ? 0 - bits : bits;
  const std::string fraction = std::to_string(magnitude % kNsPerSecond);
  std::string text(time_ns < 0 ? 1 : 0, '-');
  text.append(std::to_string(magnitude / kNsPerSecond)).append(1, '.');
  return text.append(9 - fraction.size(), '0').append(fraction);
}

std::string FormatDouble(double value) {
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), result.ptr);
}

// From 10^15 on, the same as FormatGeneral: further digits before the point are meaningless, and
// there may be 309.
std::string FormatFixed(double value, int decimals) {
  constexpr double kExact = 1e15;
  if (std::abs(value) >= kExact) return FormatGeneral(value, 6);
  return Formatted(value, std::chars_format::fixed, decimals);
}

std::string FormatGeneral(double value, int digits) {
  return Formatted(value, std::chars_format::general, digits);
}

std::string FormatSigned(double value, int digits) {
  return StrCat(std::signbit(value) ? "" : "+", FormatGeneral(value, digits));
}

double RoundedTo(double value, int digits) {
  return ParseDouble(FormatGeneral(value, digits)).value_or(value);
}

TimeUnit TimeUnitOf(const std::vector<std::string_view>& texts, double longest_step_s) {
  constexpr double kLargestClock_s = 1e11;
  constexpr std::array kNames = {"s", "ms", "us", "ns"};
  std::vector<double> times;
  for (const std::string_view text : texts) {
    if (const auto time = ParseDouble(text)) times.push_back(*time);
  }
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  const double step = steps.empty() ? 0.0 : Median(std::move(steps));
  double per_second = 1.0;
  std::size_t unit = 0;
  while (unit + 1 < kNames.size() &&
         (step > longest_step_s * per_second ||
          (!times.empty() && times.front() > kLargestClock_s * per_second))) {
    per_second *= 1000.0;
    ++unit;
  }
  return {kNames[unit], static_cast<std::int64_t>(1e9 / per_second), step / per_second};
}

}  // namespace cvo
