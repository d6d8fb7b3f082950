// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/detector/detector_process.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cvo::synth {
namespace {

// Fraction of a process with time constant `time_s` that remains after `dt_s`.
double Decay(double dt_s, double time_s) { return time_s > 0.0 ? std::exp(-dt_s / time_s) : 0.0; }

}  // namespace

double SlowNormal::Step(Rng& rng, double dt_s, double time_s) {
  const double kept = started_ ? Decay(dt_s, time_s) : 0.0;
  value_ = kept * value_ + std::sqrt(1.0 - kept * kept) * rng.Normal();
  started_ = true;
  return value_;
}

PixelBox EdgeJitter::Step(Rng& rng, double dt_s, const PixelBox& box,
                          const DetectorOptions& options) {
  std::array<double, 4> error;
  for (std::size_t edge = 0; edge < 4; ++edge) {
    const double slow = slow_[edge].Step(rng, dt_s, options.jitter_time_s);
    error[edge] =
        std::sqrt(options.jitter_slow) * slow + std::sqrt(1.0 - options.jitter_slow) * rng.Normal();
  }
  const double horizontal_px =
      std::hypot(options.jitter_width * (box.right - box.left), options.jitter_floor_px);
  const double vertical_px =
      std::hypot(options.jitter_height * (box.bottom - box.top), options.jitter_floor_px);
  return {box.left + horizontal_px * error[0], box.top + vertical_px * error[1],
          box.right + horizontal_px * error[2], box.bottom + vertical_px * error[3]};
}

bool Burst::Step(Rng& rng, double dt_s, double rate_hz, double duration_s) {
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

int Poisson(Rng& rng, double mean) {
  const double limit = std::exp(-mean);
  int events = 0;
  for (double product = rng.Uniform(); product > limit; product *= rng.Uniform()) ++events;
  return events;
}

PixelBox Tidy(PixelBox box, int width_px, int height_px) {
  if (box.right < box.left) std::swap(box.left, box.right);
  if (box.bottom < box.top) std::swap(box.top, box.bottom);
  box.left = std::clamp(box.left, 0.0, width_px - 1.0);
  box.top = std::clamp(box.top, 0.0, height_px - 1.0);
  box.right = std::clamp(box.right, box.left, width_px - 1.0);
  box.bottom = std::clamp(box.bottom, box.top, height_px - 1.0);
  return box;
}

}  // namespace cvo::synth
