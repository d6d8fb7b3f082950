// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/runner/file_hashes.h"
#include "experiments/suite/suite.h"

namespace cvo {

// Values of PlanJob::missing for input that only has to be made first.
inline constexpr char kNotRendered[] = "not rendered yet";
inline constexpr char kNotDetected[] = "boxes not found yet";
inline bool IsPending(const std::string& missing) {
  return missing == kNotRendered || missing == kNotDetected;
}

// PlanJob::missing starts with this if a file of boxes, labels or a network does not exist,
// which is not a failure.
inline constexpr std::string_view kNoFile = "no file ";

// Everything that a suite runs, as stored in plan.json in its output folder.
struct Plan {
  Suite suite;
  std::string build;  // BuildInfo::identity
  std::string data;   // absolute path to the files of boxes, labels and systems; empty: none
  std::vector<PlanJob> jobs;
};

// Describes a job to the user, as in "indoor_1 full, seed 3, pairwise.alpha=5".
std::string Describe(const PlanJob& job);

// Returns the content of plan.json, a reports::PlanFile.
std::string PlanText(const Plan& plan);
Plan ParsePlan(const Json& json, const std::string& where);

struct PlanRequest {
  std::filesystem::path data;                 // searched for sequence folders; empty: there is none
  std::filesystem::path cache;                // synth::CacheFolder()
  int threads = 1;                            // for hashing images
  Notice notice = [](const std::string&) {};  // reports damaged cache entries, which only cost time
  // Counts jobs; may be empty.
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

// Locates the input of every job: rendered scenes in the cache, folders below the data folder.
// Images are not decoded, and those that FindImageHashes knows are not read. Missing input is
// recorded in the job, never thrown.
BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request);

}  // namespace cvo
