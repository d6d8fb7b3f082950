// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <opencv2/core/types.hpp>
#include <vector>

#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/interface/options.h"
#include "experiments/cache/content_hash.h"
#include "experiments/cache/front_end_cache.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/frame_source.h"

namespace cvo {

// The output of the front end for a pair of image files.
struct ExtractedFrame {
  FrontEndFrame front_end;
  ImageHashes hashes;
  StageTimes times_s;
};

// Returns the frame with its timestamp, and with each problem naming the image file in the
// sequence.
PreparedFrame Prepare(const Sequence& sequence, std::size_t index, ExtractedFrame extracted);

// Decodes images and extracts features on the pool, a few frames ahead of the consumer. The frames
// do not depend on the number of threads. Images of at most kFrames frames are in memory. The
// sequence, options and pool must outlive it.
class LookAhead final : public FrameSource {
 public:
  static constexpr std::size_t kFrames = 3;

  LookAhead(const Sequence& sequence, const Options& options, TaskPool& pool,
            std::size_t first_frame = 0);

  // Returns the next frame of the sequence. Works on it in the calling thread if no other has taken
  // it.
  ExtractedFrame Extract();
  PreparedFrame Next() override;

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
  const std::vector<std::vector<cv::Rect2d>> boxes_;  // of the sequence's detections, by frame
  std::size_t submitted_ = 0;
  std::deque<Submitted> ahead_;
};

}  // namespace cvo
