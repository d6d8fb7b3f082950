// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/results/plan_file.h"

namespace cvo {

// A network that finds a sequence's boxes (clustervo detect). Files are below the data folder.
struct SuiteDetector {
  std::string model;  // empty: none
  std::string weights;
  std::string names;
  std::string input;  // "WIDTHxHEIGHT"
  std::optional<double> min_score;
  std::optional<double> max_overlap;
};

// One sequence of a suite, as written: a scene that is rendered, or a folder of images.
struct SuiteSequence {
  std::string scene;    // shipped name or scene file; empty: a folder
  std::string folder;   // below the suite's data folder; empty: a scene
  std::string name;     // for rows; default: the scene's or the folder's last part
  std::string frames;   // "A:B"; empty: all
  std::string dataset;  // as SequenceRequest, empty: decide from the folder
  std::string pair;     // the same
  std::string groundtruth = "devkit";
  // Level, "labels", a file below the data folder, or empty: none. Of a detector: its name.
  std::string detections;
  SuiteDetector detector;
  int detections_camera = -1;
  std::optional<double> min_score;
  std::vector<std::string> classes;  // of detections that count; empty: RigidClasses()
  std::string labels;                // file below the data folder; empty: the folder's own
  Json layout = Json::object();      // settings of the folder's layout (SequenceRequest)
  Json perturb = Json::object();     // done to its images and calibration (Perturbation)
};

// "development" or "test" for scenes (synth/family/family.h), "none" for other seeds of a family,
// "given" for a folder of images. Shipped scenes are for development.
std::string SplitOf(const SuiteSequence& sequence);

// Name of the family that a scene is drawn from; empty: none.
std::string FamilyOf(const SuiteSequence& sequence);

// Values that one option takes, in order: of the estimator ("pairwise.alpha") or, with "scene."
// before it, of the scene file ("scene.detector.miss_rate": over the level that a sequence names),
// with "perturb." of SuiteSequence::perturb.
struct GridAxis {
  std::string path;
  std::vector<Json> values;
};

// Trajectories that another system made: scored as they are.
struct SuiteSystem {
  struct Files {
    std::string sequence;  // SuiteSequence::name
    std::string camera;    // TUM or KITTI poses; below the data folder
    std::string objects;   // KITTI tracking rows with 3D boxes; empty: none
  };
  std::string name;
  std::vector<Files> files;
  bool shipped = false;  // they come with the program (shipped_trajectories.h); paths are empty
};

// What experiment table makes of the results.
using SuiteTable = reports::PlanTable;

// Of one suite, which is planned as a whole.
inline constexpr std::size_t kMaxRuns = 100'000;

// A suite file: what is run on what, and how it is tabulated.
struct Suite {
  std::string name;
  std::string about;
  std::vector<SuiteSequence> sequences;
  std::vector<std::string> variants;
  std::vector<std::uint64_t> seeds;  // of sensor, detector and the estimator's draws
  Json options = Json::object();     // nested, over the defaults; the same for all
  std::vector<GridAxis> grid;        // every combination
  bool grid_one_at_a_time = false;   // instead: each axis alone, the others at their defaults
  std::vector<std::vector<std::string>> oracles = {{}};  // sets of switches (runner/oracle.h)
  std::vector<SuiteSystem> systems;
  int timed_threads = 0;   // jobs run one at a time, each with so many threads; 0: not timed
  bool landmarks = false;  // jobs of the first seed keep every landmark: what overlays draw
  SuiteTable table;
};

// Of all its sequences: one of the above, or "mixed".
std::string SplitOf(const Suite& suite);

}  // namespace cvo
