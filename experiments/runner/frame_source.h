// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/interface/frame.h"
#include "core/interface/options.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/front_end_cache.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_result.h"

namespace cvo {

// A frame as it is given to the estimator.
struct PreparedFrame {
  StereoFrame frame;
  ImageHashes hashes;
  std::vector<ImageProblem> problems;  // if not empty: no features, skip the frame
  StageTimes times_s;                  // decode and extract: the sum over both images
};

// Supplies the frames of a sequence in order.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  // Returns the next frame. Rethrows what the extraction threw. Must be called at most once per
  // frame.
  virtual PreparedFrame Next() = 0;
  // Tells the source that the run has taken every frame and is complete.
  virtual void Finish() {}
};

// What frames are made from. All of it must outlive the source.
struct FrameInput {
  const Sequence& sequence;
  const Options& options;
  const std::vector<ImageHashes>& images;  // of every frame; empty: not known
  const FrontEndCache* cache = nullptr;    // may be null
};

// Reads frames from the cache if it has them; no image is decoded in this case. Otherwise extracts
// them, and records them if there is a cache. The frames are the same in every case.
std::unique_ptr<FrameSource> OpenFrames(const FrameInput& input, TaskPool& pool);

}  // namespace cvo
