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
  std::filesystem::path data;   // below it folders are looked for; empty: there is none
  std::filesystem::path cache;  // synth::CacheFolder()
  int threads = 1;              // that hash images
  Notice notice = [](const std::string&) {};  // of damage in the cache: it costs time only
  std::function<void(std::size_t done, std::size_t total)> progress;  // over cells; may be empty
};

// What some jobs wait for, in the order in which it is made: a drawn scene, scenes with the noise
// of other seeds, which take from it what was drawn, and boxes of a detector.
enum class Stage { kDrawing, kNoise, kBoxes };
inline constexpr std::array kStages = {Stage::kDrawing, Stage::kNoise, Stage::kBoxes};

struct Preparation {
  std::string name;                    // unique among the plan's
  std::string sequence;                // SuiteSequence::name
  std::filesystem::path output;        // folder of the scene, file of the boxes
  std::vector<std::string> arguments;  // of the program, that write it
  int frames = 0;
  Stage stage = Stage::kDrawing;
};

struct BuiltPlan {
  Plan plan;
  std::vector<Preparation> preparations;  // by stage; their jobs are kNotRendered or kNotDetected
};

// Finds the input of every cell: rendered scenes in the cache, folders below the data folder.
// Nothing is decoded, and images that FindImageHashes knows are not read. What is missing is said
// in the job, never thrown.
BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request);

}  // namespace cvo
