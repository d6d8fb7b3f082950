// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/cache/cache_size.h"
#include "experiments/suite/plan.h"

namespace cvo {

struct PlanRequest {
  std::filesystem::path data;   // below it folders are looked for; empty: there is none
  std::filesystem::path cache;  // synth::CacheFolder()
  int threads = 1;              // that hash images
  Notice notice = [](const std::string&) {};  // of damage in the cache: it costs time only
  std::function<void(std::size_t done, std::size_t total)> progress;  // over cells; may be empty
};

// A scene that some jobs wait for.
struct SceneRender {
  std::string name;      // unique among the plan's
  std::string sequence;  // SuiteSequence::name
  std::filesystem::path folder;
  std::vector<std::string> arguments;  // of the program: it renders the scene into the folder
  int frames = 0;
  bool draws = false;  // must end before the others start, which take from it what was drawn
};

struct BuiltPlan {
  Plan plan;
  std::vector<SceneRender> renders;  // those that draw first; jobs of these are kNotRendered
};

// Finds the input of every cell: rendered scenes in the cache, folders below the data folder.
// Nothing is decoded, and images that FindImageHashes knows are not read. What is missing is said
// in the job, never thrown.
BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request);

}  // namespace cvo
