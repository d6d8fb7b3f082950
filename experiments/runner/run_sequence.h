// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/interface/options.h"
#include "experiments/cache/content_hash.h"
#include "experiments/cache/front_end_cache.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/sequence.h"
#include "experiments/log/run_record.h"
#include "experiments/runner/frame_detections.h"
#include "experiments/runner/oracle.h"
#include "variants/registry.h"

namespace cvo {

struct RunRequest {
  const Sequence& sequence;
  const VariantInfo& variant;
  Options options;
  std::uint64_t seed = 0;
  int threads = 1;                                    // results do not depend on it
  std::vector<std::string> classes = RigidClasses();  // of detections that count, see there
  OracleSwitches oracle = {};
  bool landmarks = false;  // RunJob writes landmarks.csv
  bool strict = false;  // an image that cannot be decoded is an error in place of a skipped frame
  std::vector<ImageHashes> images = {};  // of every frame, as FindImageHashes; empty: not known
  const FrontEndCache* cache = nullptr;  // may be null; results do not depend on it
  std::function<void(std::size_t done)> progress = [](std::size_t) {};
  std::function<bool()> stop = [] { return false; };  // asked after every frame
};

// Takes the LandmarkRows of each frame.
using LandmarkSink = std::function<void(const std::string& rows)>;

// Runs the variant over every frame of the sequence. Empty where `stop` ended it. An Error of the
// estimator itself is a result too (status failed, frames so far); all others are thrown. With
// `truth`, landmarks are noted with what they are; the time for that is no part of the run's. What
// is kept of a long run is in a file in `spool_folder`; empty: in memory.
[[nodiscard]] std::optional<RunResult> RunSequence(const RunRequest& request,
                                                   BodyTruthReader* truth = nullptr,
                                                   const LandmarkSink& landmarks = {},
                                                   const std::filesystem::path& spool_folder = {});

}  // namespace cvo
