// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/interface/frame.h"
#include "core/interface/options.h"
#include "experiments/cache/content_hash.h"
#include "experiments/cache/front_end_cache.h"
#include "experiments/datasets/sequence.h"
#include "experiments/log/run_record.h"

namespace cvo {

// One frame as the estimator is given it.
struct PreparedFrame {
  StereoFrame frame;
  ImageHashes hashes;
  std::vector<ImageProblem> problems;  // not empty: there are no features, skip the frame
  StageTimes times_s;                  // decode and extract: the sum over both images
};

// Gives the frames of a sequence in order.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  // Throws what the extraction threw. Call it once per frame at most.
  virtual PreparedFrame Next() = 0;
  // Says that the run took every frame and is complete.
  virtual void Finish() {}
};

// What frames are made of. All of it must outlive the source.
struct FrameInput {
  const Sequence& sequence;
  const Options& options;
  const std::vector<ImageHashes>& images;  // of every frame; empty: not known
  const FrontEndCache* cache = nullptr;    // may be null
};

// Frames from the cache, where it has them: no image is read then. Else extracted, and for the
// cache if there is one. The frames are the same in every case.
std::unique_ptr<FrameSource> OpenFrames(const FrameInput& input, TaskPool& pool);

}  // namespace cvo
