// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cvo {

// The whole text as a number, independent of the locale; empty where it is none. NaN and infinity
// are no numbers.
[[nodiscard]] std::optional<double> ParseDouble(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> ParseInteger(std::string_view text);

// Decimal seconds ("1305031102.175304", "1.000000e-01") in ns, without a detour through double.
// Digits beyond the ninth are rounded, half away from zero. Empty beyond 146 years.
[[nodiscard]] std::optional<std::int64_t> ParseSecondsNs(std::string_view text);
std::string FormatSecondsNs(std::int64_t time_ns);

// The shortest decimal that reads back as the same double.
std::string FormatDouble(double value);
// With a fixed number of digits after the point.
std::string FormatFixed(double value, int decimals);
// With a maximum number of significant digits, as printf's %g.
std::string FormatGeneral(double value, int digits);
// The same with its sign, be it a plus.
std::string FormatSigned(double value, int digits);
// The number that FormatGeneral writes.
double RoundedTo(double value, int digits);

}  // namespace cvo
