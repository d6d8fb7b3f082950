// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/task_pool.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/identity.h"

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

struct FileHashHooks {
  Notice notice = [](const std::string&) {};
  // Called with the number of files read so far, if they have to be read.
  std::function<void(std::size_t done, std::size_t total)> hashed = [](std::size_t, std::size_t) {};
  // Wall-clock time, as in the timestamps of files.
  std::function<std::int64_t()> now_ns = [] {
    return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
  };
};

// Returns the SHA-256 of each file; empty if there is no such regular file. The hashes of this list
// of files are kept in `folder` (empty: nowhere): if no file has changed since, none is read. They
// are not kept if a file has changed within the last two seconds, as its timestamp may not reveal
// another change. Damaged or unwritable hashes only cost time. Throws Error for a file that cannot
// be read.
std::vector<std::string> FindFileHashes(const std::vector<std::filesystem::path>& files,
                                        const std::filesystem::path& folder, TaskPool& pool,
                                        const FileHashHooks& hooks = {});
// Returns the hashes of a sequence's images, for ContentHash.
std::vector<ImageHashes> FindImageHashes(const Sequence& sequence,
                                         const std::filesystem::path& folder, TaskPool& pool,
                                         const FileHashHooks& hooks = {});

}  // namespace cvo
