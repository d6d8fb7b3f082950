// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace cvo {

// One line for the user about something that a run goes on without.
using Notice = std::function<void(const std::string& line)>;

// Largest size of the front-end cache, bytes: `option` if not empty ("20G"; K, M, G, T are powers
// of 1000), else CLUSTERVO_CACHE_SIZE, else 20 GB. Throws Error for another text.
std::uint64_t CacheLimit(const std::string& option);

}  // namespace cvo
