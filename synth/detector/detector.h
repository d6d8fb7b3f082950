// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "synth/detector/detector_options.h"
#include "synth/truth/truth.h"

namespace cvo::synth {

// Input of a detector. Of the truth it uses times, visible boxes, pixels and fractions.
struct DetectorInput {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::string> categories;  // [id - 1]
  std::span<const FrameTruth> frames;   // in the order of time
};

struct Detection {
  int frame = 0;  // index into DetectorInput::frames
  int body = 0;   // 0: a false positive
  std::string category;
  PixelBox box;
  double score = 0.0;
};

// Every body has a random stream of its own, so that changing one option leaves the rest as it is.
// Jitter follows a first-order autoregressive process, bursts of misses a Markov chain.
std::vector<Detection> Detect(const DetectorInput& input, const DetectorOptions& options,
                              std::uint64_t seed);

// KITTI tracking detections, 18 columns, without track ids.
std::string FormatDetections(const std::vector<Detection>& detections);

}  // namespace cvo::synth
