// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/detector/detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "synth/sensor/sensor.h"
#include "synth/truth/truth.h"

namespace cvo::synth {
namespace {

// Fraction of a process with time constant `time_s` that remains after `dt_s`.
double Decay(double dt_s, double time_s) { return time_s > 0.0 ? std::exp(-dt_s / time_s) : 0.0; }

// A stationary Gaussian process of unit variance with correlation time `time_s`
// (Ornstein-Uhlenbeck).
class SlowNormal {
 public:
  // `dt_s` is the time since the previous step. The first step draws from the stationary
  // distribution.
  double Step(Rng& rng, double dt_s, double time_s) {
    const double kept = started_ ? Decay(dt_s, time_s) : 0.0;
    value_ = kept * value_ + std::sqrt(1.0 - kept * kept) * rng.Normal();
    started_ = true;
    return value_;
  }

 private:
  double value_ = 0.0;
  bool started_ = false;
};

// Jitter of the four edges of a box.
class EdgeJitter {
 public:
  ImageBox Step(Rng& rng, double dt_s, const ImageBox& box, const DetectorOptions& options) {
    std::array<double, 4> error;
    for (std::size_t edge = 0; edge < 4; ++edge) {
      const double slow = slow_[edge].Step(rng, dt_s, options.jitter_time_s);
      error[edge] = std::sqrt(options.jitter_slow) * slow +
                    std::sqrt(1.0 - options.jitter_slow) * rng.Normal();
    }
    const double horizontal_px =
        std::hypot(options.jitter_width * (box.right_px - box.left_px), options.jitter_floor_px);
    const double vertical_px =
        std::hypot(options.jitter_height * (box.bottom_px - box.top_px), options.jitter_floor_px);
    return {box.left_px + horizontal_px * error[0], box.top_px + vertical_px * error[1],
            box.right_px + horizontal_px * error[2], box.bottom_px + vertical_px * error[3]};
  }

 private:
  std::array<SlowNormal, 4> slow_;
};

// An on-off process: while off, it switches on at the rate `rate_hz`, and it then stays on for
// `duration_s` on average.
class Burst {
 public:
  bool Step(Rng& rng, double dt_s, double rate_hz, double duration_s) {
    const double draw = rng.Uniform();
    if (!started_) {
      started_ = true;
      on_ = draw < rate_hz * duration_s / (1.0 + rate_hz * duration_s);
    } else if (on_) {
      on_ = draw < Decay(dt_s, duration_s);
    } else {
      on_ = duration_s > 0.0 && draw < 1.0 - std::exp(-dt_s * rate_hz);
    }
    return on_;
  }

 private:
  bool on_ = false;
  bool started_ = false;
};

// Draws from the Poisson distribution with this mean (Knuth's method, for small means).
int Poisson(Rng& rng, double mean) {
  const double limit = std::exp(-mean);
  int events = 0;
  for (double product = rng.Uniform(); product > limit; product *= rng.Uniform()) ++events;
  return events;
}

// Puts the sides of a box in order and clamps them to the image.
ImageBox Tidy(ImageBox box, int width_px, int height_px) {
  if (box.right_px < box.left_px) std::swap(box.left_px, box.right_px);
  if (box.bottom_px < box.top_px) std::swap(box.top_px, box.bottom_px);
  box.left_px = std::clamp(box.left_px, 0.0, width_px - 1.0);
  box.top_px = std::clamp(box.top_px, 0.0, height_px - 1.0);
  box.right_px = std::clamp(box.right_px, box.left_px, width_px - 1.0);
  box.bottom_px = std::clamp(box.bottom_px, box.top_px, height_px - 1.0);
  return box;
}

// 0 if `half` = 0; otherwise 1/2 at `value` = `half` and small well above it.
double MissProbability(double value, double half) {
  return half > 0.0 ? 1.0 / (1.0 + std::pow(value / half, 4)) : 0.0;
}

double Score(double mean, double spread, double normal) {
  return std::clamp(mean + spread * normal, 0.01, 1.0);
}

// Random state of one body over time, whether it is visible or not.
struct BodyProcess {
  Rng rng;
  EdgeJitter jitter;
  Burst burst;
};

// A false positive.
struct FalseBox {
  ImageBox box;
  std::string category;
  EdgeJitter jitter;
};

class Detector {
 public:
  Detector(const DetectorInput& input, const DetectorOptions& options, std::uint64_t seed)
      : input_(input), options_(options), seed_(seed), false_box_rng_(seed, "detector false") {
    for (std::size_t i = 0; i < input.categories.size(); ++i) {
      bodies_.push_back({Rng(seed, StrCat("detector body ", i + 1)), {}, {}});
    }
    for (const FrameTruth& frame : input.frames) {
      for (const BodyTruth& body : frame.bodies) {
        if (body.visible_px < options.min_visible_px) continue;
        real_boxes_.emplace_back(body.id, *body.visible_box);
      }
    }
  }

  std::vector<SimulatedDetection> Run() {
    std::vector<SimulatedDetection> all;
    for (std::size_t i = 0; i < input_.frames.size(); ++i) {
      const FrameTruth& frame = input_.frames[i];
      dt_s_ = i == 0 ? 0.0 : frame.time_s - input_.frames[i - 1].time_s;
      std::vector<SimulatedDetection> found = FindBodies(frame);
      Merge(found);
      AddFalseBoxes(i == 0, found);
      for (SimulatedDetection& detection : found) {
        detection.frame = static_cast<int>(i);
        all.push_back(std::move(detection));
      }
    }
    return all;
  }

 private:
  std::vector<SimulatedDetection> FindBodies(const FrameTruth& frame) {
    std::vector<SimulatedDetection> found;
    for (const BodyTruth& body : frame.bodies) {
      const auto index = static_cast<std::size_t>(body.id - 1);
      BodyProcess& process = bodies_.at(index);
      const ImageBox visible = body.visible_box.value_or(ImageBox{});
      // Make all draws in every frame, visible or not, so that one outcome does not shift the next.
      const ImageBox box = process.jitter.Step(process.rng, dt_s_, visible, options_);
      const bool lost =
          process.burst.Step(process.rng, dt_s_, options_.burst_rate_hz, options_.burst_s);
      const double draw = process.rng.Uniform();
      const double score_draw = process.rng.Normal();
      if (!body.visible_box || body.visible_px < options_.min_visible_px) continue;
      if (lost || draw < ProbabilityOfMiss(body)) continue;
      found.push_back({0, body.id, input_.categories[index],
                       Tidy(box, input_.width_px, input_.height_px),
                       Score(options_.score_mean, options_.score_spread, score_draw)});
    }
    return found;
  }

  double ProbabilityOfMiss(const BodyTruth& body) const {
    const ImageBox& box = *body.visible_box;
    const double side_px = std::min(box.right_px - box.left_px, box.bottom_px - box.top_px) + 1.0;
    return 1.0 - (1.0 - options_.miss_rate) *
                     (1.0 - MissProbability(side_px, options_.miss_size_px)) *
                     (1.0 - MissProbability(body.visible_fraction, options_.miss_visible));
  }

  // Whether the detector merges two neighbours into one box in this frame.
  bool AreMerged(int a, int b) {
    const auto key = std::minmax(a, b);
    auto [pair, added] = pairs_.try_emplace(
        key, Rng(seed_, StrCat("detector pair ", key.first, " ", key.second)), SlowNormal());
    auto& [rng, process] = pair->second;
    return NormalCdf(process.Step(rng, dt_s_, options_.jitter_time_s)) < options_.merge_rate;
  }

  void Merge(std::vector<SimulatedDetection>& found) {
    if (options_.merge_rate == 0.0) return;
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (std::size_t k = i + 1; k < found.size(); ++k) {
        if (found[i].category != found[k].category) continue;
        if (IntersectionOverUnion(found[i].box, found[k].box) < options_.merge_overlap) continue;
        if (!AreMerged(found[i].body, found[k].body)) continue;
        ImageBox& box = found[i].box;
        const ImageBox other = found[k].box;
        box = {std::min(box.left_px, other.left_px), std::min(box.top_px, other.top_px),
               std::max(box.right_px, other.right_px), std::max(box.bottom_px, other.bottom_px)};
        found[i].score = std::max(found[i].score, found[k].score);
        found.erase(found.begin() + static_cast<std::ptrdiff_t>(k));
        --k;
      }
    }
  }

  void AddFalseBoxes(bool first, std::vector<SimulatedDetection>& found) {
    if (real_boxes_.empty()) return;
    const double stays =
        options_.false_positive_s > 0.0 ? std::exp(-dt_s_ / options_.false_positive_s) : 0.0;
    std::erase_if(false_boxes_, [&](const FalseBox&) { return false_box_rng_.Uniform() >= stays; });
    const double born = options_.false_positives * (first ? 1.0 : 1.0 - stays);
    for (int count = Poisson(false_box_rng_, born); count > 0; --count)
      false_boxes_.push_back(MakeFalseBox());
    for (FalseBox& false_box : false_boxes_) {
      const ImageBox box = false_box.jitter.Step(false_box_rng_, dt_s_, false_box.box, options_);
      found.push_back(
          {0, 0, false_box.category, Tidy(box, input_.width_px, input_.height_px),
           Score(options_.false_score_mean, options_.false_score_spread, false_box_rng_.Normal())});
    }
  }

  // Makes a box of about the size of a real one at a random position.
  FalseBox MakeFalseBox() {
    const auto& [body, like] = real_boxes_[false_box_rng_.UniformInt(real_boxes_.size())];
    const double scale = false_box_rng_.Uniform(0.6, 1.2);
    const double width = scale * (like.right_px - like.left_px);
    const double height = scale * (like.bottom_px - like.top_px);
    const double left = false_box_rng_.Uniform(0.0, std::max(input_.width_px - 1.0 - width, 1.0));
    const double top = false_box_rng_.Uniform(0.0, std::max(input_.height_px - 1.0 - height, 1.0));
    return {{left, top, left + width, top + height},
            input_.categories[static_cast<std::size_t>(body - 1)],
            {}};
  }

  const DetectorInput& input_;
  const DetectorOptions& options_;
  std::uint64_t seed_;
  double dt_s_ = 0.0;
  std::vector<BodyProcess> bodies_;
  std::map<std::pair<int, int>, std::pair<Rng, SlowNormal>> pairs_;
  Rng false_box_rng_;
  std::vector<FalseBox> false_boxes_;
  std::vector<std::pair<int, ImageBox>> real_boxes_;
};

DetectorOptions Oracle() {
  DetectorOptions oracle;
  oracle.jitter_width = oracle.jitter_height = oracle.jitter_floor_px = 0.0;
  oracle.miss_rate = oracle.miss_size_px = oracle.miss_visible = oracle.burst_rate_hz = 0.0;
  oracle.false_positives = oracle.merge_rate = 0.0;
  oracle.min_visible_px = 1;
  oracle.score_mean = 1.0;
  oracle.score_spread = 0.0;
  return oracle;
}

DetectorOptions Poor() {
  DetectorOptions poor;
  poor.jitter_width = 0.12;
  poor.jitter_height = 0.1;
  poor.jitter_floor_px = 2.0;
  poor.miss_rate = 0.05;
  poor.miss_size_px = 24.0;
  poor.miss_visible = 0.35;
  poor.burst_rate_hz = 0.5;
  poor.burst_s = 0.5;
  poor.false_positives = 0.8;
  poor.merge_rate = 0.8;
  poor.merge_overlap = 0.3;
  poor.score_mean = 0.75;
  poor.score_spread = 0.15;
  return poor;
}

}  // namespace

const std::vector<std::string>& DetectorLevels() {
  static const std::vector<std::string> levels = {"oracle", "good", "poor"};
  return levels;
}

DetectorOptions DetectorLevel(const std::string& level) {
  if (level == "oracle") return Oracle();
  if (level == "good") return {};
  if (level == "poor") return Poor();
  ThrowError("detector level", Quoted(level) + DidYouMean(level, DetectorLevels()),
             "oracle, good or poor");
}

std::vector<SimulatedDetection> Detect(const DetectorInput& input, const DetectorOptions& options,
                                       std::uint64_t seed) {
  return Detector(input, options, seed).Run();
}

std::string FormatDetections(const std::vector<SimulatedDetection>& detections) {
  std::string rows;
  for (const SimulatedDetection& detection : detections) {
    rows += StrCat(detection.frame, " -1 ", detection.category, " -1 -1 -10");
    for (const double side : {detection.box.left_px, detection.box.top_px, detection.box.right_px,
                              detection.box.bottom_px}) {
      rows += StrCat(" ", FormatFixed(side, 2));
    }
    rows += StrCat(" -1 -1 -1 -1000 -1000 -1000 -10 ", FormatFixed(detection.score, 4), "\n");
  }
  return rows;
}

}  // namespace cvo::synth
