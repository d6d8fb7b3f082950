// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/frame_source.h"

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "experiments/record/build_identity.h"
#include "experiments/runner/frame_detections.h"
#include "experiments/runner/look_ahead.h"

namespace cvo {
namespace {

FrontEndSettings Settings(const FrameInput& input) {
  const Sequence& sequence = input.sequence;
  return {.build = ThisBuild().identity,
          .camera = sequence.camera,
          .orb = input.options.orb,
          .stereo = input.options.stereo,
          .boxes = BoxesByFrame(sequence),
          .perturbation = sequence.perturbation,
          .rectification = sequence.rectification,
          .first_frame = sequence.first_frame};
}

// Extracts the frames and records them for later runs, under the hashes of the bytes that it read.
class RecordedFrames final : public FrameSource {
 public:
  RecordedFrames(const FrameInput& input, TaskPool& pool)
      : RecordedFrames(input, {}, input.cache->Record(), pool) {}
  // From the frame after these images on; `recording` has the frames of these.
  RecordedFrames(const FrameInput& input, std::vector<ImageHashes> images,
                 FrontEndRecording recording, TaskPool& pool)
      : input_(input),
        frames_(input.sequence, input.options, pool, images.size()),
        recording_(std::move(recording)),
        images_(std::move(images)) {}

  PreparedFrame Next() override {
    ExtractedFrame extracted = frames_.Extract();
    images_.push_back(extracted.hashes);
    {
      const ScopedStage stage(extracted.times_s, "store_features");
      recording_.Add(extracted.front_end);
    }
    return Prepare(input_.sequence, images_.size() - 1, std::move(extracted));
  }

  void Finish() override { recording_.Finish(FrontEndKey(Settings(input_), images_)); }

 private:
  const FrameInput input_;
  LookAhead frames_;
  FrontEndRecording recording_;
  std::vector<ImageHashes> images_;
};

// Reads frames from the cache. If one cannot be read, extracts this one and all after it, and makes
// the entry again.
class CachedFrames final : public FrameSource {
 public:
  CachedFrames(const FrameInput& input, std::vector<ImageHashes> images, std::string key,
               FeatureFile file, TaskPool& pool)
      : input_(input),
        images_(std::move(images)),
        key_(std::move(key)),
        file_(std::move(file)),
        pool_(pool) {}

  PreparedFrame Next() override {
    const std::size_t index = next_++;
    if (file_) {
      ExtractedFrame cached;
      if (Load(index, cached)) return Prepare(input_.sequence, index, std::move(cached));
      ExtractFrom(index);
    }
    return rest_->Next();
  }

  void Finish() override {
    if (rest_) rest_->Finish();
  }

 private:
  bool Load(std::size_t index, ExtractedFrame& cached) {
    try {
      const ScopedStage stage(cached.times_s, "load_features");
      cached.front_end = file_->Frame(index);
      cached.hashes = images_.at(index);
      return true;
    } catch (const std::exception& damage) {
      input_.cache->Remove(key_, damage.what());
      return false;
    }
  }

  void ExtractFrom(std::size_t index) {
    FrontEndRecording recording = input_.cache->Record();
    recording.AddFrames(*file_, index);
    file_.reset();
    images_.resize(index);
    rest_.emplace(input_, std::move(images_), std::move(recording), pool_);
  }

  const FrameInput input_;
  std::vector<ImageHashes> images_;
  std::string key_;
  std::optional<FeatureFile> file_;
  TaskPool& pool_;
  std::optional<RecordedFrames> rest_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> OpenFrames(const FrameInput& input, TaskPool& pool) {
  if (input.cache == nullptr) {
    return std::make_unique<LookAhead>(input.sequence, input.options, pool);
  }
  std::vector<ImageHashes> images =
      input.images.empty() ? HashImages(input.sequence) : input.images;
  std::string key = FrontEndKey(Settings(input), images);
  if (auto file = input.cache->Find(key, images.size())) {
    return std::make_unique<CachedFrames>(input, std::move(images), std::move(key),
                                          std::move(*file), pool);
  }
  return std::make_unique<RecordedFrames>(input, pool);
}

}  // namespace cvo
