// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/job_cache.h"

#include "core/base/task_pool.h"

namespace cvo {

JobCache::JobCache(const std::filesystem::path& cache_folder, std::uint64_t limit_bytes,
                   const FileHashHooks& hooks)
    : folder_(cache_folder),
      hooks_(hooks),
      hashes_(cache_folder / "hashes"),
      front_end_(cache_folder / "frontend", limit_bytes, hooks.notice) {}

std::vector<std::string> JobCache::HashesOf(const std::vector<std::filesystem::path>& files,
                                            int threads) const {
  TaskPool pool(threads);
  return FindFileHashes(files, hashes_, pool, hooks_);
}

std::vector<ImageHashes> JobCache::ImagesOf(const Sequence& sequence, int threads) const {
  TaskPool pool(threads);
  return FindImageHashes(sequence, hashes_, pool, hooks_);
}

void JobCache::Serve(RunRequest& request) const {
  request.images = ImagesOf(request.sequence, request.threads);
  request.cache = &front_end_;
}

}  // namespace cvo
