// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "core/base/task_pool.h"
#include "experiments/cache/cache_size.h"
#include "experiments/cache/content_hash.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

struct FileHashHooks {
  Notice notice = [](const std::string&) {};
  // Files whose bytes were read so far, of those that have to be.
  std::function<void(std::size_t done, std::size_t total)> hashed = [](std::size_t, std::size_t) {};
  // Time of day, as files are stamped with.
  std::function<std::int64_t()> now_ns = [] {
    return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
  };
};

// SHA-256 of each file, empty where it cannot be read, without reading one whose hash is known from
// the index in `index_folder` (empty: there is none). What had to be read is added to the index,
// but for files that changed within the last two seconds, whose stamp may not tell another change.
// An index that cannot be used costs time only.
std::vector<std::string> FindFileHashes(const std::vector<std::filesystem::path>& files,
                                        const std::filesystem::path& index_folder, TaskPool& pool,
                                        const FileHashHooks& hooks = {});
// Those of a sequence's images, for ContentHash.
std::vector<ImageHashes> FindImageHashes(const Sequence& sequence,
                                         const std::filesystem::path& index_folder, TaskPool& pool,
                                         const FileHashHooks& hooks = {});

}  // namespace cvo
