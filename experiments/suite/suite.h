// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "core/record/suite_runs.h"

namespace cvo {

// A neural network that detects a sequence's boxes (clustervo detect). Its files are below the data
// folder.
struct SuiteDetector {
  std::string model;  // empty: none
  std::string weights;
  std::string names;
  std::string input;  // "WIDTHxHEIGHT"
  std::optional<double> min_score;
  std::optional<double> max_overlap;
};

// One sequence of a suite, as written in the suite file: a scene to render, or a folder of images.
struct SuiteSequence {
  std::string scene;    // shipped name or scene file; empty: a folder
  std::string folder;   // below the suite's data folder; empty: a scene
  std::string name;     // for rows; default: the last component of the scene's or folder's path
  std::string frames;   // "A:B"; empty: all
  std::string dataset;  // as in SequenceRequest; empty: determined from the folder
  std::string pair;     // as in SequenceRequest; empty: determined from the folder
  std::string groundtruth = "devkit";
  // Level of the scene's detector, "labels", a file below the data folder, or empty for none. With
  // `detector`: the name of that detector.
  std::string detections;
  SuiteDetector detector;
  int detections_camera = -1;
  std::optional<double> min_score;
  std::vector<std::string> classes;  // of detections to use; empty: RigidClasses()
  std::string labels;                // file below the data folder; empty: the labels in the folder
  Json layout = Json::object();      // settings of the folder's layout (SequenceRequest)
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

// Trajectories estimated by another system, scored as they are.
struct SuiteSystem {
  struct Files {
    std::string sequence;  // SuiteSequence::name
    std::string camera;    // file of TUM or KITTI poses, below the data folder
    std::string objects;   // KITTI tracking rows with 3D boxes; empty: none
  };
  std::string name;
  std::vector<Files> files;
  bool shipped = false;  // shipped with the program (shipped_trajectories.h); paths are empty
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
  std::vector<std::vector<std::string>> oracles = {{}};  // sets of switches (runner/oracle.h)
  std::vector<SuiteSystem> systems;
  int timed_threads = 0;   // threads per job, jobs run one at a time; 0: not timed
  bool landmarks = false;  // jobs of the first seed record every landmark, for overlays
  SuiteTable table;
};

// Returns the common split of all sequences, as above, or "mixed".
std::string SplitOf(const Suite& suite);

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

// Returns the suite as a file that ParseSuite reads back, with everything resolved.
Json SuiteToJson(const Suite& suite);

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
Suite Override(Suite suite, const SuiteOverrides& overrides);

// Returns a list of texts. Throws Error naming `where` for anything else.
std::vector<std::string> ReadTexts(const Json& value, const std::string& where);

}  // namespace cvo
