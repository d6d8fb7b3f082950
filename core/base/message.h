// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace cvo {

inline constexpr std::size_t kMaxMessage = 300;

// Returns the text, without its middle if it is longer than kMaxMessage bytes: files may hold long
// texts, and messages are for people.
std::string Shortened(const std::string& text);

}  // namespace cvo
