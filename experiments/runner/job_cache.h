// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "experiments/cache/file_hashes.h"
#include "experiments/cache/front_end_cache.h"
#include "experiments/runner/run_sequence.h"

namespace cvo {

// The caches that runs share, below the cache folder: features (frontend/) and hashes of files
// (hashes/).
class JobCache {
 public:
  // `limit_bytes` is that of the features; see CacheLimit.
  JobCache(const std::filesystem::path& cache_folder, std::uint64_t limit_bytes,
           const FileHashHooks& hooks);

  const std::filesystem::path& folder() const { return folder_; }

  // See FindFileHashes.
  std::vector<std::string> HashesOf(const std::vector<std::filesystem::path>& files,
                                    int threads) const;
  // Returns the hashes of the sequence's images, for ContentHash and IdentifyJob.
  std::vector<ImageHashes> ImagesOf(const Sequence& sequence, int threads) const;
  // Fills in the image hashes of the request and lets it use the cached features. The cache must
  // outlive the request.
  void Serve(RunRequest& request) const;

 private:
  std::filesystem::path folder_;
  FileHashHooks hooks_;
  std::filesystem::path hashes_;
  FrontEndCache front_end_;
};

}  // namespace cvo
