// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// Parses the whole text as a number, independently of the locale. Empty if it is not a number; NaN
// and infinity are not.
[[nodiscard]] std::optional<double> ParseDouble(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> ParseInteger(std::string_view text);
[[nodiscard]] std::optional<int> ParseInt(std::string_view text);

// Parses a decimal time ("1305031102.175304", "1.000000e-01") in a unit, a power of ten of 1 ns, to
// ns, without going through double. Digits beyond 1 ns are rounded, half away from zero. Empty if
// the text is not a number, or for a time beyond 146 years.
[[nodiscard]] std::optional<std::int64_t> ParseTimeNs(std::string_view text, std::int64_t unit_ns);
std::string FormatSecondsNs(std::int64_t time_ns);

// Returns the shortest decimal that parses back to the same double.
std::string FormatDouble(double value);
// Formats with a fixed number of digits after the decimal point.
std::string FormatFixed(double value, int decimals);
// Formats with a maximum number of significant digits, like %g of printf.
std::string FormatGeneral(double value, int digits);
// The same, always with a sign.
std::string FormatSigned(double value, int digits);
// Returns the number that FormatGeneral writes.
double RoundedTo(double value, int digits);

// The unit of times, and their median step in it: the longest one in which the step is at most
// `longest_step_s` and the first time a clock's, which counts seconds from 1970 in 10 digits.
struct TimeUnit {
  const char* name = "s";  // s, ms, us, ns
  std::int64_t ns = 1'000'000'000;
  double step_s = 0.0;
};
TimeUnit TimeUnitOf(const std::vector<std::string_view>& texts, double longest_step_s);

}  // namespace cvo
