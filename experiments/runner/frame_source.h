// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/interface/options.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/front_end_cache.h"
#include "experiments/runner/identity.h"

namespace cvo {

// The output of the front end for a pair of image files.
struct PreparedFrame : FrontEndFrame {
  ImageHashes hashes;
  StageTimes times_s;  // decode and extract: the sum over both images
};

// What frames are made from. All of it must outlive the source.
struct FrameInput {
  const Sequence& sequence;
  const Options& options;
  const std::vector<ImageHashes>& images;  // of every frame; needed with a cache
  const FrontEndCache* cache = nullptr;    // may be null
};

class LookAhead;

// Supplies the frames of a sequence in order. Reads them from the cache if it has them; no image is
// decoded in this case. Otherwise extracts them, and records them if there is a cache: the frames
// are the same. If one of the cache cannot be read, extracts this one and all after it; the next
// run makes the entry again.
class FrameSource {
 public:
  FrameSource(const FrameInput& input, TaskPool& pool);
  ~FrameSource();
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;

  // Returns the next frame. Rethrows what the extraction threw. Must be called at most once per
  // frame.
  PreparedFrame Next();
  // The run has taken every frame and is complete. An image that has changed leaves no entry.
  void Finish();

 private:
  // Returns false if the file is damaged, which removes it.
  bool ReadNext(std::size_t index, PreparedFrame& frame);

  const FrameInput input_;
  TaskPool& pool_;
  std::vector<ImageHashes> images_;  // as hashed before; those of recorded frames as read
  std::string key_;
  std::optional<FeatureFile> file_;
  std::optional<FeatureRecording> recording_;
  std::unique_ptr<LookAhead> ahead_;
  std::size_t next_ = 0;
};

}  // namespace cvo
