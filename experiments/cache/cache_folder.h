// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace cvo {

// Takes a line for the user about a problem that does not end the run.
using Notice = std::function<void(const std::string& line)>;

// Returns the maximum size of the front-end cache in bytes: `option` if not empty ("20G"; K, M, G,
// T are powers of 1000), else CLUSTERVO_CACHE_SIZE, else 20 GB. Throws Error for text that is not a
// size.
std::uint64_t CacheLimit(const std::string& option);

// Makes the file the most recently used, which TrimFolder removes last. Fails silently, for example
// in a folder of another user.
void MarkUsed(const std::filesystem::path& file);

// Removes files, least recently used first, until the rest is within the limit. Temporaries do not
// count. Files that cannot be removed stay.
void TrimFolder(const std::filesystem::path& folder, std::uint64_t limit_bytes);

}  // namespace cvo
