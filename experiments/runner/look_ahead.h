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
#include "experiments/cache/front_end_frame.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/frame_source.h"

namespace cvo {

// What the front end made of a pair of image files.
struct ExtractedFrame {
  FrontEndFrame front_end;
  ImageHashes hashes;
  StageTimes times_s;
};

// The frame with its time and with problems named by the files of the sequence.
PreparedFrame Prepare(const Sequence& sequence, std::size_t index, ExtractedFrame extracted);

// Decodes images and extracts features on the pool, a few frames ahead of whoever takes them. The
// frames do not depend on the number of threads; images of no more than kFrames frames are in
// memory. The sequence, options and pool must outlive it.
class LookAhead final : public FrameSource {
 public:
  static constexpr std::size_t kFrames = 3;

  LookAhead(const Sequence& sequence, const Options& options, TaskPool& pool,
            std::size_t first_frame = 0);

  // The next frame of the sequence; works on it meanwhile if no thread has taken it.
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
