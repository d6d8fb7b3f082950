// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace cvo {
namespace internal {

template <const std::string_view& kFirst, const std::string_view& kSecond>
constexpr auto JoinText() {
  std::array<char, kFirst.size() + kSecond.size()> text{};
  std::size_t at = 0;
  for (const std::string_view part : {kFirst, kSecond}) {
    for (const char c : part) text[at++] = c;
  }
  return text;
}

template <const std::string_view& kFirst, const std::string_view& kSecond>
inline constexpr auto kJoinedText = JoinText<kFirst, kSecond>();

}  // namespace internal

// Two texts concatenated at compile time.
template <const std::string_view& kFirst, const std::string_view& kSecond>
inline constexpr std::string_view kJoined(internal::kJoinedText<kFirst, kSecond>.data(),
                                          internal::kJoinedText<kFirst, kSecond>.size());

}  // namespace cvo
