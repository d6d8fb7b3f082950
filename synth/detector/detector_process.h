// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "core/base/rng.h"
#include "synth/detector/detector_options.h"
#include "synth/truth/truth.h"

namespace cvo::synth {

// A stationary Gaussian process of unit variance with correlation time `time_s`
// (Ornstein-Uhlenbeck).
class SlowNormal {
 public:
  // `dt_s` is the time since the previous step. The first step draws from the stationary
  // distribution.
  double Step(Rng& rng, double dt_s, double time_s);

 private:
  double value_ = 0.0;
  bool started_ = false;
};

// Jitter of the four edges of a box.
class EdgeJitter {
 public:
  PixelBox Step(Rng& rng, double dt_s, const PixelBox& box, const DetectorOptions& options);

 private:
  std::array<SlowNormal, 4> slow_;
};

// An on-off process: while off, it switches on at the rate `rate_hz`, and it then stays on for
// `duration_s` on average.
class Burst {
 public:
  bool Step(Rng& rng, double dt_s, double rate_hz, double duration_s);

 private:
  bool on_ = false;
  bool started_ = false;
};

// Draws from the Poisson distribution with this mean (Knuth's method, for small means).
int Poisson(Rng& rng, double mean);

// Puts the sides of a box in order and clamps them to the image.
PixelBox Tidy(PixelBox box, int width_px, int height_px);

}  // namespace cvo::synth
