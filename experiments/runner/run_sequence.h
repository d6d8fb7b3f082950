// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/interface/options.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/frame_detections.h"
#include "experiments/runner/front_end_cache.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/oracle.h"
#include "experiments/runner/run_result.h"
#include "variants/registry.h"

namespace cvo {

struct RunRequest {
  const Sequence& sequence;
  const VariantInfo& variant;
  Options options;
  std::uint64_t seed = 0;
  int threads = 1;                                    // results do not depend on it
  std::vector<std::string> classes = RigidClasses();  // of the detections that are used
  OracleSwitches oracle = {};
  bool landmarks = false;  // RunJob writes landmarks.csv
  bool strict = false;     // an image that cannot be decoded is an error, not a skipped frame
  std::vector<ImageHashes> images = {};  // of every frame, from FindImageHashes; empty: unknown
  const FrontEndCache* cache = nullptr;  // may be null; results do not depend on it
  std::function<void(std::size_t done)> progress = [](std::size_t) {};
  std::function<bool()> stop = [] { return false; };  // called after every frame
};

// Receives the LandmarkRows of each frame.
using LandmarkSink = std::function<void(const std::string& rows)>;

// Runs the variant over every frame of the sequence. Returns nothing if `stop` ended the run. An
// Error of the estimator itself is a result too (status failed, with the frames so far); all others
// are thrown. With `truth`, the ground truth of landmarks is recorded; the time for that does not
// count as the run's.
[[nodiscard]] std::optional<RunResult> RunSequence(const RunRequest& request,
                                                   BodyTruthReader* truth = nullptr,
                                                   const LandmarkSink& landmarks = {});

}  // namespace cvo
