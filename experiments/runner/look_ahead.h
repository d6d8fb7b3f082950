// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/odometry/frame.h"
#include "core/odometry/options.h"
#include "experiments/datasets/sequence.h"
#include "experiments/record/run_record.h"
#include "experiments/runner/content_hash.h"

namespace cvo {

// One frame as the estimator is given it.
struct PreparedFrame {
  StereoFrame frame;
  ImageHashes hashes;
  std::vector<ImageProblem> problems;  // not empty: there are no features, skip the frame
  StageTimes times_s;                  // decode and extract: the sum over both images
};

// Decodes images and extracts features on the pool, a few frames ahead of whoever takes them. The
// frames do not depend on the number of threads; images of no more than kFrames frames are in
// memory. The sequence, options and pool must outlive it.
class LookAhead {
 public:
  static constexpr std::size_t kFrames = 3;

  LookAhead(const Sequence& sequence, const Options& options, TaskPool& pool);

  // The next frame of the sequence in order; works on it meanwhile if no thread has taken it.
  // Throws what the extraction threw. Call it once per frame at most.
  PreparedFrame Next();

 private:
  struct Slot;
  struct Submitted {
    std::shared_ptr<Slot> slot;
    std::array<TaskPool::Ticket, 2> tickets;
  };

  void SubmitNext();

  const Sequence& sequence_;
  const Options& options_;
  TaskPool& pool_;
  std::size_t submitted_ = 0;
  std::deque<Submitted> ahead_;
};

}  // namespace cvo
