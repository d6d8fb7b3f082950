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

// Input of the simulated detector. It uses the times, visible boxes, visible pixels and visible
// fractions of the ground truth.
struct DetectorInput {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::string> categories;  // [id - 1]
  std::span<const FrameTruth> frames;   // in temporal order
};

struct Detection {
  int frame = 0;  // index into DetectorInput::frames
  int body = 0;   // 0: a false positive
  std::string category;
  PixelBox box;
  double score = 0.0;
};

// Simulates a detector. Every body has its own random stream, so that changing one option leaves
// all other errors unchanged. Jitter follows a first-order autoregressive process, bursts of misses
// a Markov chain.
std::vector<Detection> Detect(const DetectorInput& input, const DetectorOptions& options,
                              std::uint64_t seed);

// Formats detections in the KITTI tracking format: 18 columns, without track ids.
std::string FormatDetections(const std::vector<Detection>& detections);

}  // namespace cvo::synth
