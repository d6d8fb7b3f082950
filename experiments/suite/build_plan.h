// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/identity.h"
#include "experiments/suite/suite.h"

namespace cvo {

// A scene that jobs wait for.
struct Preparation {
  std::string name;      // unique within the plan
  std::string sequence;  // SuiteSequence::name
  // <cache>/scenes/<name>-<key>/<name>: the scene as rendered for one seed and one grid point.
  std::filesystem::path output;
  std::vector<std::string> arguments;  // of the program, to write `output`
  int frames = 0;
  std::string drawing = {};  // key of the drawing, which all seeds share
  bool draws = true;         // false: only adds noise to a drawing, which is made before
};

// Returns what is wrong with a rendered folder: an unreadable manifest, or the first file that is
// missing or differs from the manifest. Of per-frame files, only those of `frames` are checked.
std::optional<std::string> FindSceneDamage(const std::filesystem::path& folder,
                                           const FrameRange& frames = {});

// Throws Error if the sequence is a rendered folder and a file that a run on it may read is not the
// one that was rendered.
void RequireAsRendered(const Sequence& sequence);

// HashImages of a sequence that is as rendered (RequireAsRendered), without reading it again.
std::vector<ImageHashes> RenderedHashes(const Sequence& sequence);

using reports::kNotRendered;

// PlanJob::missing starts with this if a file of boxes or labels does not exist, which is not a
// failure.
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
  Notice notice = [](const std::string&) {};  // reports damaged cache entries, which only cost time
  // Counts jobs; may be empty.
  std::function<void(std::size_t done, std::size_t total)> progress;
};

struct BuiltPlan {
  Plan plan;
  // Those that draw come first. The jobs that wait for them are kNotRendered.
  std::vector<Preparation> preparations;
};

// Locates the input of every job: rendered scenes in the cache, folders below the data folder.
// Images are not decoded, and those whose hashes are known are not read. Missing input is
// recorded in the job, never thrown.
BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request);

// Where one scene of a suite is rendered below the cache, and how. Throws Error for an invalid
// scene, and if no renderer is available.
Preparation FindScene(const std::filesystem::path& cache, const SuiteSequence& sequence,
                      const GridPoint& parameters, std::uint64_t seed);

}  // namespace cvo
