// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/frame_source.h"

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

// Extracts the frames and records them for later runs under `key`, that of the images as they were
// before.
class RecordedFrames final : public FrameSource {
 public:
  RecordedFrames(const FrameInput& input, std::string key, TaskPool& pool)
      : input_(input),
        frames_(input.sequence, input.options, pool),
        recording_(input.cache->Record(key)),
        key_(std::move(key)) {}

  PreparedFrame Next() override {
    ExtractedFrame extracted = frames_.Extract();
    images_.push_back(extracted.hashes);
    {
      const ScopedStage stage(extracted.times_s, "store_features");
      recording_.Add(extracted.front_end);
    }
    return Prepare(input_.sequence, images_.size() - 1, std::move(extracted));
  }

  // An image that has changed since leaves no entry.
  void Finish() override {
    if (FrontEndKey(Settings(input_), images_) == key_) recording_.Finish();
  }

 private:
  const FrameInput input_;
  LookAhead frames_;
  FeatureRecording recording_;
  std::vector<ImageHashes> images_;
  std::string key_;
};

// Reads frames from the cache. If one cannot be read, extracts this one and all after it; the next
// run makes the entry again.
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
    if (rest_) return rest_->Next();
    ExtractedFrame cached;
    try {
      const ScopedStage stage(cached.times_s, "load_features");
      cached.front_end = file_.Next();
      cached.hashes = images_.at(index);
    } catch (const Error& damage) {
      input_.cache->Remove(key_, damage.what());
      rest_.emplace(input_.sequence, input_.options, pool_, index);
      return rest_->Next();
    }
    return Prepare(input_.sequence, index, std::move(cached));
  }

 private:
  const FrameInput input_;
  std::vector<ImageHashes> images_;
  std::string key_;
  FeatureFile file_;
  TaskPool& pool_;
  std::optional<LookAhead> rest_;
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
  if (key.empty()) return std::make_unique<LookAhead>(input.sequence, input.options, pool);
  if (std::optional<FeatureFile> file = input.cache->Find(key)) {
    return std::make_unique<CachedFrames>(input, std::move(images), std::move(key),
                                          *std::move(file), pool);
  }
  return std::make_unique<RecordedFrames>(input, std::move(key), pool);
}

}  // namespace cvo
