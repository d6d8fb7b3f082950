// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

namespace cvo {

inline constexpr std::size_t kMaxMessage = 300;

// Returns the text, without its middle if it is longer than kMaxMessage bytes: files may hold long
// texts, and messages are for people.
std::string Shortened(const std::string& text);

// Invalid input or a broken invariant. The message is one line: where (file, line or field), what
// was found, and what was expected.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Concatenates its arguments as an output stream would print them. Floating-point numbers have up
// to twelve digits, because a message must distinguish 1.0000001 from 1.
template <typename... Args>
std::string StrCat(const Args&... args) {
  std::ostringstream out;
  out.precision(12);
  (out << ... << args);
  return out.str();
}

// Throws Error("<where>: found <found>, expected <expected>").
[[noreturn]] void ThrowError(const std::string& where, const std::string& found,
                             const std::string& expected);

// Throws Error if a condition that callers must guarantee does not hold, in every build type.
void Require(bool condition, const char* message);

}  // namespace cvo
