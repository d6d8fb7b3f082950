// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/frame_source.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <deque>
#include <memory>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/features/front_end.h"
#include "core/features/orb/orb.h"
#include "core/features/stereo_matcher.h"
#include "core/interface/options.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/frame_detections.h"
#include "experiments/runner/front_end_cache.h"
#include "experiments/runner/identity.h"

namespace cvo {
namespace {

// The output of the front end for a pair of image files.
struct ExtractedFrame {
  FrontEndFrame front_end;
  ImageHashes hashes;
  StageTimes times_s;
};

// Returns the frame with its timestamp, and with each problem naming the image file in the
// sequence.
PreparedFrame Prepare(const Sequence& sequence, std::size_t index, ExtractedFrame extracted) {
  PreparedFrame prepared;
  prepared.frame.timestamp_ns = sequence.timestamps_ns[index];
  prepared.frame.features = std::move(extracted.front_end.features);
  prepared.hashes = std::move(extracted.hashes);
  prepared.times_s = std::move(extracted.times_s);
  const StereoPaths& paths = sequence.images[index];
  for (SideProblem& problem : extracted.front_end.problems) {
    const std::filesystem::path& image = problem.side == 0 ? paths.left : paths.right;
    prepared.problems.push_back(
        {image.lexically_relative(sequence.folder).generic_string(), std::move(problem.reason)});
  }
  return prepared;
}

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

// One image of a pair, processed by one task.
struct Side {
  OrbImage orb;
  std::string sha256;
  std::string problem;  // without the path
  StageTimes times_s;
};

// Removes the path at the beginning of a problem's description.
std::string WithoutPath(const std::string& problem, const std::filesystem::path& path) {
  const std::string prefix = path.string() + ": ";
  return problem.starts_with(prefix) ? problem.substr(prefix.size()) : problem;
}

// One image of a sequence: the left (0) or right (1) one of a frame.
struct SideOfFrame {
  const Sequence& sequence;
  std::size_t index;
  int side;
};

Side PrepareSide(const SideOfFrame& of, const OrbOptions& options,
                 const std::vector<CornerRegion>& regions) {
  const StereoPaths& paths = of.sequence.images[of.index];
  const std::filesystem::path& path = of.side == 0 ? paths.left : paths.right;
  Side side;
  LoadedImage image;
  {
    const ScopedStage stage(side.times_s, "decode");
    image = LoadFrameImage(of.sequence, of.index, of.side);
  }
  side.sha256 = image.sha256;
  side.problem = WithoutPath(image.problem, path);
  if (!image.ok()) return side;
  if (IsDropped(of.sequence, of.index)) {
    side.problem = "found a frame dropped by perturb.drop_rate, expected an image";
    return side;
  }
  PerturbImage(of.sequence, of.index, of.side, image.grey);
  const ScopedStage stage(side.times_s, "extract");
  side.orb = ExtractOrb(image.grey, options, regions);
  return side;
}

void AddTimes(const StageTimes& from, StageTimes& to) {
  for (const auto& [stage, seconds] : from) to[stage] += seconds;
}

struct LookAhead::Slot {
  std::vector<cv::Rect2d> boxes;
  std::array<Side, 2> sides;
  std::vector<StereoFeature> features;
  StageTimes match_times_s;
  std::atomic<int> unfinished = 2;

  bool BothValid() const { return sides[0].problem.empty() && sides[1].problem.empty(); }

  // Matches the pair and frees the pyramids, which are not needed afterwards while the frame waits.
  void Match(const Sequence& sequence, const Options& options) {
    if (BothValid()) {
      const ScopedStage stage(match_times_s, "match_stereo");
      features = MatchStereo(sides[0].orb, sides[1].orb, sequence.camera, options.orb,
                             options.stereo, boxes);
    }
    for (Side& side : sides) side.orb = {};
  }
};

LookAhead::LookAhead(const Sequence& sequence, const Options& options, TaskPool& pool,
                     std::size_t first_frame)
    : sequence_(sequence),
      options_(options),
      pool_(pool),
      boxes_(BoxesByFrame(sequence)),
      submitted_(first_frame) {
  for (std::size_t i = 0; i < kFrames; ++i) SubmitNext();
}

void LookAhead::SubmitNext() {
  if (submitted_ == sequence_.images.size()) return;
  const std::size_t index = submitted_++;
  const std::vector<CornerRegion> regions =
      LeftRegions(std::span(boxes_).first(index + 1), options_.orb);
  Submitted next;
  next.slot = std::make_shared<Slot>();
  next.slot->boxes = boxes_[index];
  for (std::size_t side = 0; side < 2; ++side) {
    // The task uses no member of this object: an error may end the run, and the object's lifetime,
    // while tasks are still running.
    next.tickets[side] = pool_.Submit([slot = next.slot, side, index, &sequence = sequence_,
                                       &options = options_, regions] {
      const SideOfFrame of{sequence, index, static_cast<int>(side)};
      slot->sides[side] = side == 0
                              ? PrepareSide(of, options.orb, regions)
                              : PrepareSide(of, RightOrb(options.orb, options.stereo),
                                            RightRegions(regions, options.stereo, sequence.camera));
      // The task that finishes last matches the pair. After an error the count stays above zero.
      if (slot->unfinished.fetch_sub(1) == 1) slot->Match(sequence, options);
    });
  }
  ahead_.push_back(std::move(next));
}

ExtractedFrame LookAhead::Extract() {
  Require(!ahead_.empty(), "LookAhead: no frame is left");
  const Submitted submitted = std::move(ahead_.front());
  ahead_.pop_front();
  for (const TaskPool::Ticket& ticket : submitted.tickets) pool_.Wait(ticket);

  Slot& slot = *submitted.slot;
  ExtractedFrame extracted;
  extracted.front_end.features = std::move(slot.features);
  extracted.hashes = {slot.sides[0].sha256, slot.sides[1].sha256};
  extracted.times_s = slot.match_times_s;
  for (int side = 0; side < 2; ++side) {
    Side& image = slot.sides[static_cast<std::size_t>(side)];
    AddTimes(image.times_s, extracted.times_s);
    if (image.problem.empty()) continue;
    extracted.front_end.problems.push_back({side, std::move(image.problem)});
  }
  SubmitNext();
  return extracted;
}

PreparedFrame LookAhead::Next() {
  const std::size_t index = submitted_ - ahead_.size();
  return Prepare(sequence_, index, Extract());
}

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
