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
  int frame = 0;  // as numbered in the sequence's folder
  std::int64_t timestamp_ns = 0;
  // With the poses as estimated when the frame was processed, and without its landmarks, which are
  // many.
  FrameReport report;
  RigidTransform refined_world_from_camera;    // as last estimated, at the end of the run
  std::vector<Detection> detections;           // as given to the estimator
  std::vector<LandmarkObservation> landmarks;  // counts; only where bodies have a ground truth
  std::vector<ImageProblem> problems;          // why the frame was skipped
};

// The frames of a run, in order. They are stored in a Spool; only their positions in it are kept in
// memory. Reading a frame returns a copy.
class FrameLog {
 public:
  // `folder`: of the Spool.
  explicit FrameLog(std::filesystem::path folder = {}) : spool_(std::move(folder)) {}
  FrameLog(const std::vector<FrameRecord>& frames);  // NOLINT(google-explicit-constructor)

  void Append(const FrameRecord& frame);
  // Sets the refined poses of all frames, which replace those appended with the frames.
  void Refine(std::vector<RigidTransform> world_from_camera);

  std::size_t size() const { return begins_.size(); }
  bool empty() const { return begins_.empty(); }
  FrameRecord operator[](std::size_t index) const;

  // Holds one frame in memory. A reference to it is valid until the next increment.
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
  std::vector<RigidTransform> refined_world_from_camera_;  // empty: as appended
};

}  // namespace cvo
