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
#include "experiments/runner/front_end_cache.h"
#include "experiments/runner/given.h"
#include "experiments/runner/identity.h"

namespace cvo {

// Decodes images and extracts features on the pool, a few frames ahead of the consumer. The frames
// do not depend on the number of threads. Images of at most kFrames frames are in memory. The
// sequence, options and pool must outlive it.
class LookAhead {
 public:
  static constexpr std::size_t kFrames = 3;

  LookAhead(const Sequence& sequence, const Options& options, TaskPool& pool,
            std::size_t first_frame);

  // Returns the next frame of the sequence. Works on it in the calling thread if no other has taken
  // it.
  PreparedFrame Next();

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
struct PreparedSide {
  OrbImage orb;
  std::string sha256;
  std::string problem;  // without the path
  StageTimes times_s;
};

namespace {

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

PreparedSide PrepareSide(const SideOfFrame& of, const OrbOptions& options,
                         const std::vector<CornerRegion>& regions) {
  const StereoPaths& paths = of.sequence.images[of.index];
  const std::filesystem::path& path = of.side == 0 ? paths.left : paths.right;
  PreparedSide side;
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

}  // namespace

struct LookAhead::Slot {
  std::vector<cv::Rect2d> boxes;
  std::array<PreparedSide, 2> sides;
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
    for (PreparedSide& side : sides) side.orb = {};
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

PreparedFrame LookAhead::Next() {
  Require(!ahead_.empty(), "LookAhead: no frame is left");
  const Submitted submitted = std::move(ahead_.front());
  ahead_.pop_front();
  for (const TaskPool::Ticket& ticket : submitted.tickets) pool_.Wait(ticket);

  Slot& slot = *submitted.slot;
  PreparedFrame extracted;
  extracted.features = std::move(slot.features);
  extracted.hashes = {slot.sides[0].sha256, slot.sides[1].sha256};
  extracted.times_s = slot.match_times_s;
  for (int side = 0; side < 2; ++side) {
    PreparedSide& image = slot.sides[static_cast<std::size_t>(side)];
    AddTimes(image.times_s, extracted.times_s);
    if (image.problem.empty()) continue;
    extracted.problems.push_back({side, std::move(image.problem)});
  }
  SubmitNext();
  return extracted;
}

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

}  // namespace

FrameSource::FrameSource(const FrameInput& input, TaskPool& pool) : input_(input), pool_(pool) {
  if (input.cache == nullptr) return;
  images_ = input.images;
  key_ = FrontEndKey(Settings(input), images_);
  if (key_.empty()) return;
  file_ = input.cache->Find(key_);
  if (!file_) recording_.emplace(input.cache->Record(key_));
}

FrameSource::~FrameSource() = default;

PreparedFrame FrameSource::Next() {
  const std::size_t index = next_++;
  PreparedFrame frame;
  if (file_ && ReadNext(index, frame)) return frame;
  if (!ahead_) {
    ahead_ = std::make_unique<LookAhead>(input_.sequence, input_.options, pool_, index);
  }
  frame = ahead_->Next();
  if (recording_) {
    const ScopedStage stage(frame.times_s, "store_features");
    recording_->Add(frame);
    images_[index] = frame.hashes;
  }
  return frame;
}

void FrameSource::Finish() {
  if (recording_ && FrontEndKey(Settings(input_), images_) == key_) recording_->Finish();
}

bool FrameSource::ReadNext(std::size_t index, PreparedFrame& frame) {
  try {
    const ScopedStage stage(frame.times_s, "load_features");
    static_cast<FrontEndFrame&>(frame) = file_->Next();
    frame.hashes = images_.at(index);
    return true;
  } catch (const Error& damage) {
    input_.cache->Remove(key_, damage.what());
    file_.reset();
    return false;
  }
}

}  // namespace cvo
