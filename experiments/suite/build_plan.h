// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/identity.h"
#include "experiments/suite/suite.h"
#include "synth/write/dataset.h"

namespace cvo {

// The user's data folder. Sequences are found by their path below it, or by the end of their path.
class DataFolder {
 public:
  // An empty `root` means that there is no data folder. The folder is searched on first need.
  explicit DataFolder(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }

  struct Found {
    std::filesystem::path folder;  // absolute; empty: missing
    std::string missing;           // why it is missing, for the user
  };
  Found Find(const std::string& folder);

 private:
  const std::vector<FoundSequence>& All();

  std::filesystem::path root_;
  std::optional<std::vector<FoundSequence>> all_;
};

// Rendering of a scene that jobs wait for, in the order in which they run: drawing it, and adding
// the noise of further seeds to that drawing.
enum class Stage { kDrawing, kNoise };
inline constexpr std::array kStages = {Stage::kDrawing, Stage::kNoise};

struct Preparation {
  std::string name;      // unique within the plan
  std::string sequence;  // SuiteSequence::name
  // <cache>/scenes/<name>-<key>/<name>: the scene as rendered for one seed and one grid point.
  std::filesystem::path output;
  std::vector<std::string> arguments;  // of the program, to write `output`
  int frames = 0;
  Stage stage = Stage::kDrawing;  // kNoise if its drawing is in the cache
  std::string drawing = {};       // key of the drawing, which all seeds share
};

// Finds scenes below <cache>/scenes by a key of what determines their content: the scene, the
// values assigned to it, the seed, the frames and the program that draws.
class SceneFolders {
 public:
  explicit SceneFolders(std::filesystem::path cache) : cache_(std::move(cache)) {}

  // Throws Error for an invalid scene, and if no renderer is available.
  Preparation Find(const SuiteSequence& sequence, const GridPoint& parameters, std::uint64_t seed);

 private:
  struct Source {
    synth::DatasetSource dataset;
    int frames = 0;
  };
  const Source& SourceFor(const SuiteSequence& sequence,
                          const std::vector<std::string>& assignments);

  std::filesystem::path cache_;
  std::map<std::string, Source> sources_;  // by scene and assignments
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

// Returns the first file of boxes or labels that does not exist below `data`, as
// written in the suite; empty if all exist.
std::string FindMissingFile(const SuiteSequence& sequence, const std::filesystem::path& data);

using reports::kNotRendered;

// PlanJob::missing starts with this if a file of boxes or labels does not exist,
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
  Notice notice = [](const std::string&) {};  // reports damaged cache entries, which only cost time
  // Counts jobs; may be empty.
  std::function<void(std::size_t done, std::size_t total)> progress;
};

struct BuiltPlan {
  Plan plan;
  // Ordered by stage. The jobs that wait for them are kNotRendered.
  std::vector<Preparation> preparations;
};

// Locates the input of every job: rendered scenes in the cache, folders below the data folder.
// Images are not decoded, and those whose hashes are known are not read. Missing input is
// recorded in the job, never thrown.
BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request);

}  // namespace cvo
