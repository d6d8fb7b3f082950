// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/atomic_file.h"
#include "core/files/json/json.h"
#include "core/interface/options.h"
#include "core/record/suite_runs.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/system_run.h"

namespace cvo {

// One sequence of a suite, as written in the suite file: a scene to render, or a folder of images.
// `folder` and `labels_file` are below the suite's data folder; RequestOf completes the rest.
struct SuiteSequence : SequenceRequest {
  std::string scene;   // shipped name or scene file; empty: a folder
  std::string name;    // for rows; default: the last component of the scene's or folder's path
  std::string frames;  // "A:B"; empty: all
  // Level of the scene's detector, "labels", a file below the data folder, or empty for none.
  std::string detections;
  std::vector<std::string> classes;  // of detections to use; empty: RigidClasses()
  Json perturb = Json::object();     // applied to its images and calibration (Perturbation)
};

// Returns "development" or "test" for a scene (synth/family/family.h), "none" for a family scene
// whose seed is in neither split, and "given" for a folder of images. Shipped scenes are
// development scenes.
std::string SplitOf(const SuiteSequence& sequence);

// Name of the family that the scene is drawn from; empty if there is none.
std::string FamilyOf(const SuiteSequence& sequence);

// Values that one option takes, in order. The path is that of an estimator option
// ("pairwise.alpha"), of a key in the scene file with the prefix "scene."
// ("scene.detector.miss_rate", applied on top of the level that a sequence names), or of a key in
// SuiteSequence::perturb with the prefix "perturb.".
struct GridAxis {
  std::string path;
  std::vector<Json> values;
};

// Another system: a program that is run on each sequence, or the trajectories that one has left.
struct SuiteSystem {
  std::string name;
  std::vector<std::string> command;  // with placeholders; empty: `camera` exists already
  std::vector<std::string> version;  // a command that prints the version; empty: none
  std::string calibration;           // form of {calibration}, one of CalibrationForms()
  // The files that hold its poses, as SystemFiles: with a command below {out}, else below the data
  // folder. Both empty: shipped with the program (ShippedTrajectories).
  std::string camera;
  std::string objects;
  std::vector<std::uint64_t> seeds;
  // Limits of one job instead of those of all jobs (PlanRun); 0: none.
  std::optional<double> limit_s;
  std::optional<double> limit_memory_mb;

  bool shipped() const { return camera.empty(); }
  bool Uses(const std::string& placeholder) const;  // such as "{detections}"
};

// How `experiment table` tabulates the results.
using SuiteTable = reports::PlanTable;
// One run that a suite requests; `entry` is the index of its sequence.
using reports::PlanJob;

// Maximum number of runs of one suite. A suite is planned as a whole.
inline constexpr std::size_t kMaxRuns = 100'000;

// A suite file: what runs on which sequences, and how the results are tabulated.
struct Suite {
  std::string name;
  std::string about;
  std::vector<SuiteSequence> sequences;
  std::vector<std::string> variants;
  std::vector<std::uint64_t> seeds;  // of the sensor, the detector and the estimator's random draws
  Json options = Json::object();     // nested, override the defaults; the same for all runs
  std::vector<GridAxis> grid;        // all combinations of their values are run
  bool grid_one_at_a_time = false;   // instead, vary one axis at a time from the defaults
  std::vector<std::vector<std::string>> oracles = {{}};  // sets of switches (OracleOf)
  std::vector<SuiteSystem> systems;
  int timed_threads = 0;   // threads per job, jobs run one at a time; 0: not timed
  bool landmarks = false;  // jobs of the first seed record every landmark, for overlays
  SuiteTable table;
  Json definition = Json::object();  // as read, with absolute paths of files beside the suite file
};

// Returns the common split of all sequences, as above, or "mixed".
std::string SplitOf(const Suite& suite);

// The suite files of experiments/configs, in their order of listing.
struct ShippedSuite {
  std::string name;  // as stated in `text`
  std::string text;  // JSON
};
std::vector<ShippedSuite> ShippedSuites();

// Loads a shipped suite by name, or a suite file (experiments/configs/README.md). Parsing is
// strict: throws Error naming the file and the key of anything unknown, missing, of the wrong type
// or out of range.
Suite LoadSuite(const std::string& suite);

// Parses and checks a suite. Paths of scene files are relative to `folder`; `where` names the
// source in errors.
Suite ParseSuite(const Json& json, const std::string& where,
                 const std::filesystem::path& folder = {});
// The same without CheckSuite: validates keys and types only, for a suite that has been checked
// before.
Suite ReadCheckedSuite(const Json& json, const std::string& where,
                       const std::filesystem::path& folder = {});

// Throws Error naming `where` and the key if the suite cannot be run: an unknown name, an invalid
// option, or grid points that its table would mix.
void CheckSuite(const Suite& suite, const std::string& where);

// Changes made to a suite on the command line: --seeds N (seeds 1 to N; 0: the suite's own),
// --frames and --set PATH=VALUE. A path in the suite's grid takes only the given value;
// "scene.PATH" and "perturb.PATH" apply to every sequence; any other path is an estimator option.
// Override throws Error for changes that the suite does not allow.
struct SuiteOverrides {
  int seeds = 0;
  std::vector<std::string> set;
  std::string frames = {};  // "A:B", for every sequence; empty: the suite's own
};
Suite Override(const Suite& suite, const SuiteOverrides& overrides);

// A suite given by flags: scenes and families such as "indoor_1,room@1000:1012", with their good
// detections; variants such as "full,paper"; axes such as "pairwise.alpha=0,5,20"; a file whose
// systems run on the scenes.
struct SuiteSweep {
  std::string scenes = {};    // empty: "tiny"
  std::string variants = {};  // empty: "full", or none beside systems
  std::string systems = {};
  std::vector<std::string> grid = {};
};
// Returns it as a suite file would define it.
Json SweepDefinition(const std::string& name, const SuiteSweep& sweep);

// Returns a list of texts. Throws Error naming `where` for anything else.
std::vector<std::string> ReadTexts(const Json& value, const std::string& where);

// One point of a grid: an object with the value of every axis by its path.
using GridPoint = Json;

// Parses the values of an axis as written in a suite file: a list, or {"from", "to", "steps"} with
// an optional "scale" ("linear" or "log"). Values between the ends are rounded to six significant
// digits. Throws Error naming `where`.
std::vector<Json> ParseAxisValues(const Json& json, const std::string& where);

// Returns all points, with the last axis varying fastest. One at a time: first the point with every
// axis at its default, then each axis in turn through its other values. The default of an option is
// its value for the variant (empty: for none in particular) under the suite's options; "scene." and
// "perturb." axes take theirs from the sequence.
std::vector<GridPoint> GridPoints(const Suite& suite, const SuiteSequence& sequence,
                                  const std::string& variant);

// Whether the path of an axis refers to a scene file ("scene.") or to an estimator option. Any
// other is that of a perturbation ("perturb.").
bool IsScenePath(const std::string& path);
bool IsOptionPath(const std::string& path);
// "a.b" in nested objects.
Json::json_pointer PointerTo(const std::string& path);

// Returns the estimator's options at a grid point: the variant's defaults (the general ones if
// `variant` is empty, for another system), overridden by the suite's options and then by those of
// the point. Throws Error for unknown or inconsistent options.
Options OptionsOf(const Suite& suite, const std::string& variant, const GridPoint& parameters);

// Returns the sequence's perturbation with the "perturb." values of the grid point applied over it.
// Throws Error naming the key.
Perturbation PerturbationOf(const SuiteSequence& sequence, const GridPoint& parameters,
                            std::uint64_t seed);

// Returns what a grid point assigns to the scene, as in "sensor.read_noise=0". If the point changes
// the detector, its values apply on top of the level that the sequence names.
std::vector<std::string> SceneAssignments(const SuiteSequence& sequence,
                                          const GridPoint& parameters);

// Returns the system of a job; null for a job of a variant.
const SuiteSystem* SystemOf(const Suite& suite, const PlanJob& job);

// Returns all jobs of a suite before their input is located, ordered by sequence, then seed,
// parameters, oracle and variant.
std::vector<PlanJob> ExpandSuite(const Suite& suite);

// Returns the request that opens the job's sequence, which is in `job.folder`. Files of boxes and
// labels are below `data`.
SequenceRequest RequestOf(const Suite& suite, const PlanJob& job,
                          const std::filesystem::path& data);

// Returns the level of the scene's own detector that the sequence names, or an empty string if
// there is none.
std::string DetectorLevel(const SuiteSequence& sequence);

// Returns the classes of detections to use: the sequence's own, or RigidClasses() if it has none.
std::vector<std::string> ClassesOf(const SuiteSequence& sequence);

// What another system made of a scene, a block of a file of reports/reference/trajectories.
struct ShippedTrajectory {
  std::string_view system;
  std::string_view scene;           // a shipped scene, or of a family: "room@1040,rate_hz=10"
  std::string_view frames;          // as SuiteSequence::frames, or "all"
  std::string_view scene_hash;      // of the rendered scene.json, which has the seed of the noise
  std::vector<NamedContent> files;  // camera.tum, then bodies/<id>.tum if it has bodies
};
const std::vector<ShippedTrajectory>& ShippedTrajectories();

// The system's trajectory on the sequence; null if there is none.
const ShippedTrajectory* FindShipped(const std::string& system, const SuiteSequence& sequence);

// PlanJob::missing starts with this if a shipped trajectory was made from other images.
inline constexpr std::string_view kStale = "stale: ";

// Writes what is shipped of the sequence (FindShipped) below the cache folder. Throws Error, with
// kStale, if the folder `rendered` or the job has another scene, seed, part or perturbation.
SystemFiles ShippedSystemFiles(const std::string& system, const SuiteSequence& sequence,
                               const std::filesystem::path& rendered,
                               const std::filesystem::path& cache);

// Returns the files of a job of another system that has no command, below `data`. Trajectories
// shipped with the program are written below the cache folder.
SystemFiles SystemFilesOf(const Suite& suite, const PlanJob& job, const std::filesystem::path& data,
                          const std::filesystem::path& cache);

}  // namespace cvo
