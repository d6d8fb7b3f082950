// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "core/base/rng.h"
#include "synth/detector/detector_options.h"
#include "synth/truth/truth.h"

namespace cvo::synth {

// A stationary Gaussian process of unit variance, correlated over `time_s` (Ornstein-Uhlenbeck).
class SlowNormal {
 public:
  // `dt_s` since the last step; the first step draws from the stationary distribution.
  double Step(Rng& rng, double dt_s, double time_s);

 private:
  double value_ = 0.0;
  bool started_ = false;
};

// Errors of a box's four edges.
class EdgeJitter {
 public:
  PixelBox Step(Rng& rng, double dt_s, const PixelBox& box, const DetectorOptions& options);

 private:
  std::array<SlowNormal, 4> slow_;
};

// On and off: switched on `rate_hz` times a second, for `duration_s` on average.
class Burst {
 public:
  bool Step(Rng& rng, double dt_s, double rate_hz, double duration_s);

 private:
  bool on_ = false;
  bool started_ = false;
};

// Number of events where `mean` are expected (Knuth's method: small means).
int Poisson(Rng& rng, double mean);

// Sides in order and within the image.
PixelBox Tidy(PixelBox box, int width_px, int height_px);

}  // namespace cvo::synth
