// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "core/files/spool.h"
#include "core/interface/frame.h"
#include "experiments/metrics/objects/object_estimate.h"

namespace cvo {

// An image that could not be decoded.
struct ImageProblem {
  std::string image;   // its path within the sequence's folder
  std::string reason;  // what was found and what was expected
};

// One frame of a run.
struct FrameRecord {
  int frame = 0;  // counted in the folder
  std::int64_t timestamp_ns = 0;
  // With the poses as estimated when the frame came; without its landmarks, which are many.
  FrameReport report;
  RigidTransform refined_world_from_camera;    // as last estimated, at the end of the run
  std::vector<Detection> detections;           // as the estimator was given them
  std::vector<LandmarkObservation> landmarks;  // of the report, counted; where bodies have a truth
  std::vector<ImageProblem> problems;          // why the frame was skipped
};

// The frames of a run, in order. They lie in a Spool: what a run keeps of a frame in memory is
// where it is. Whoever asks for one is given a copy.
class FrameLog {
 public:
  // `folder`: of the spool.
  explicit FrameLog(std::filesystem::path folder = {}) : spool_(std::move(folder)) {}
  FrameLog(const std::vector<FrameRecord>& frames);  // NOLINT(google-explicit-constructor)

  void Append(const FrameRecord& frame);
  // The refined poses of all frames, in place of those that came with them.
  void Refine(std::vector<RigidTransform> world_from_camera);

  std::size_t size() const { return begins_.size(); }
  bool empty() const { return begins_.empty(); }
  FrameRecord operator[](std::size_t index) const;

  // Has one frame in memory: a reference to it is good until the next step.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = FrameRecord;
    using difference_type = std::ptrdiff_t;
    using pointer = const FrameRecord*;
    using reference = const FrameRecord&;

    Iterator(const FrameLog& log, std::size_t index) : log_(&log), index_(index) { Load(); }
    reference operator*() const { return frame_; }
    pointer operator->() const { return &frame_; }
    Iterator& operator++() {
      ++index_;
      Load();
      return *this;
    }
    bool operator==(const Iterator& other) const { return index_ == other.index_; }

   private:
    void Load() {
      if (index_ < log_->size()) frame_ = (*log_)[index_];
    }

    const FrameLog* log_;
    std::size_t index_;
    FrameRecord frame_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  Spool spool_;
  std::vector<std::uint64_t> begins_;
  std::vector<RigidTransform> refined_world_from_camera_;  // empty: as they came
};

}  // namespace cvo
