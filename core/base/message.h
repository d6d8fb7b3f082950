// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace cvo {

inline constexpr std::size_t kMaxMessage = 300;

// A text that is longer than kMaxMessage bytes without its middle: what a file holds may be long,
// and messages are for people.
std::string Shortened(const std::string& text);

}  // namespace cvo
