// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/runner/file_hashes.h"
#include "experiments/runner/front_end_cache.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_sequence.h"
#include "experiments/runner/score_run.h"

namespace cvo {

struct JobOutcome {
  RunResult run;
  RunScores scores;
  reports::TimingData context = {};
  std::vector<std::string> warnings = {};  // of FindImplausible, and of much memory
};

// Returns GivenToJson of a job. Classes only count if there are boxes.
Json Given(const Sequence& sequence, const std::vector<std::string>& classes,
           const OracleSwitches& oracle);

// Returns the JobIdentity of what RunJob would do, from the bytes of the sequence's files; nothing
// is decoded. Does not read images whose hashes are in the request.
std::string IdentifyJob(const RunRequest& request);

// Runs the job, scores it and writes its files to an existing folder (WriteRunFiles). Returns
// nothing if the request's `stop` ended the run; no file is written then.
[[nodiscard]] std::optional<JobOutcome> RunJob(const RunRequest& request,
                                               const std::filesystem::path& folder);

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
