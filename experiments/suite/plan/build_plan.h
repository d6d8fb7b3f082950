// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/cache/cache_size.h"
#include "experiments/suite/plan/plan.h"

namespace cvo {

struct PlanRequest {
  std::filesystem::path data;                 // searched for sequence folders; empty: there is none
  std::filesystem::path cache;                // synth::CacheFolder()
  int threads = 1;                            // for hashing images
  Notice notice = [](const std::string&) {};  // reports damaged cache entries, which only cost time
  // Counts cells; may be empty.
  std::function<void(std::size_t done, std::size_t total)> progress;
};

// Preparations that jobs may wait for, in the order in which they run: drawing a scene, adding the
// noise of further seeds to that drawing, and detecting boxes with a network.
enum class Stage { kDrawing, kNoise, kBoxes };
inline constexpr std::array kStages = {Stage::kDrawing, Stage::kNoise, Stage::kBoxes};

struct Preparation {
  std::string name;                    // unique within the plan
  std::string sequence;                // SuiteSequence::name
  std::filesystem::path output;        // folder of the scene, or file of the boxes
  std::vector<std::string> arguments;  // of the program, to write `output`
  int frames = 0;
  Stage stage = Stage::kDrawing;
};

struct BuiltPlan {
  Plan plan;
  // Ordered by stage. The jobs that wait for them are kNotRendered or kNotDetected.
  std::vector<Preparation> preparations;
};

// Locates the input of every cell: rendered scenes in the cache, folders below the data folder.
// Images are not decoded, and those that FindImageHashes knows are not read. Missing input is
// recorded in the job, never thrown.
BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request);

}  // namespace cvo
