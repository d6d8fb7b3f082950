// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/options.h"
#include "synth/truth/truth.h"

namespace cvo::synth {

// Error model of a detector. The defaults are level "good", which is fitted to two real detectors
// (synth/README.md).
struct DetectorOptions {
  double jitter_width = 0.07;
  double jitter_height = 0.055;
  double jitter_floor_px = 0.8;
  double jitter_slow = 0.85;
  double jitter_time_s = 1.0;
  double miss_rate = 0.01;
  double miss_size_px = 14.0;
  double miss_visible = 0.2;
  double burst_rate_hz = 0.18;
  double burst_s = 0.35;
  double false_positives = 0.2;
  double false_positive_s = 0.25;
  double merge_rate = 0.5;
  double merge_overlap = 0.5;
  double score_mean = 0.9;
  double score_spread = 0.07;
  double false_score_mean = 0.5;
  double false_score_spread = 0.15;
  int min_visible_px = 64;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    constexpr const char* kFit = "regionlets and YOLOv3 on KITTI tracking 0003 and 0005";
    constexpr const char* kChoice = "chosen: neither real detector shows it often enough to fit";
    visit.Field("jitter_width", self.jitter_width,
                FieldInfo{"1", 0, 1, "std of left and right edge, part of the box's width", kFit});
    visit.Field("jitter_height", self.jitter_height,
                FieldInfo{"1", 0, 1, "std of top and bottom edge, part of its height", kFit});
    visit.Field("jitter_floor_px", self.jitter_floor_px,
                FieldInfo{"px", 0, 100, "std of each edge, added to the above", kFit});
    visit.Field("jitter_slow", self.jitter_slow,
                FieldInfo{"1", 0, 1, "part of the variance that is correlated in time", kFit});
    visit.Field("jitter_time_s", self.jitter_time_s,
                FieldInfo{"s", 0, 100, "time after which its correlation is 1/e", kFit});
    visit.Field("miss_rate", self.miss_rate,
                FieldInfo{"1", 0, 1, "of single frames, of large boxes in full view", kFit});
    visit.Field("miss_size_px", self.miss_size_px,
                FieldInfo{"px", 0, 1000, "shorter side of which half are missed", kChoice});
    visit.Field("miss_visible", self.miss_visible,
                FieldInfo{"1", 0, 1, "visible fraction of which half are missed", kChoice});
    visit.Field("burst_rate_hz", self.burst_rate_hz,
                FieldInfo{"1/s", 0, 100, "how often an object is lost for several frames", kFit});
    visit.Field("burst_s", self.burst_s, FieldInfo{"s", 0, 100, "for how long, on average", kFit});
    visit.Field("false_positives", self.false_positives,
                FieldInfo{"1", 0, 100, "boxes of nothing in a frame, on average", kFit});
    visit.Field("false_positive_s", self.false_positive_s,
                FieldInfo{"s", 0, 100, "for how long one stays, on average", kFit});
    visit.Field("merge_rate", self.merge_rate,
                FieldInfo{"1", 0, 1,
                          "part of the time in which overlapping boxes of a category "
                          "become one",
                          kChoice});
    visit.Field("merge_overlap", self.merge_overlap,
                FieldInfo{"1", 0, 1, "intersection over union from which boxes overlap", kChoice});
    visit.Field("score_mean", self.score_mean, FieldInfo{"1", 0, 1, "of an object", kChoice});
    visit.Field("score_spread", self.score_spread, FieldInfo{"1", 0, 1, "its std", kChoice});
    visit.Field("false_score_mean", self.false_score_mean,
                FieldInfo{"1", 0, 1, "score of a box of nothing", kChoice});
    visit.Field("false_score_spread", self.false_score_spread,
                FieldInfo{"1", 0, 1, "its std", kChoice});
    visit.Field("min_visible_px", self.min_visible_px,
                FieldInfo{"px", 1, 1e9, "fewer visible pixels are never detected", "8 x 8"});
  }
};

// Names of the levels: "oracle" (every visible box without error), "good", "poor".
const std::vector<std::string>& DetectorLevels();
// Throws Error for an unknown level.
DetectorOptions DetectorLevel(const std::string& level);

// Input of the simulated detector. It uses the times, visible boxes, visible pixels and visible
// fractions of the ground truth.
struct DetectorInput {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::string> categories;  // [id - 1]
  std::span<const FrameTruth> frames;   // in temporal order
};

struct SimulatedDetection {
  int frame = 0;  // index into DetectorInput::frames
  int body = 0;   // 0: a false positive
  std::string category;
  ImageBox box;
  double score = 0.0;
};

// Simulates a detector. Every body has its own random stream, so that changing one option leaves
// all other errors unchanged. Jitter follows a first-order autoregressive process, bursts of misses
// a Markov chain.
std::vector<SimulatedDetection> Detect(const DetectorInput& input, const DetectorOptions& options,
                                       std::uint64_t seed);

// Formats detections in the KITTI tracking format: 18 columns, without track ids.
std::string FormatDetections(const std::vector<SimulatedDetection>& detections);

}  // namespace cvo::synth
