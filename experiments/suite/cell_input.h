// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/interface/options.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/oracle.h"
#include "experiments/runner/system_files.h"
#include "experiments/suite/cell.h"
#include "experiments/suite/suite_grid.h"

namespace cvo {

// The options of a grid's point over the suite's, over those that the variant starts from (empty:
// another system, the defaults). Throws Error for what cannot be together.
Options OptionsOf(const Suite& suite, const std::string& variant, const GridPoint& parameters);

// The sequence's, with the point's "perturb." values over it. Throws Error naming the key.
Perturbation PerturbationOf(const SuiteSequence& sequence, const GridPoint& parameters,
                            std::uint64_t seed);

// "sensor.read_noise=0": what a point assigns to the scene. Where it touches the detector, its
// values go over the level that the sequence names.
std::vector<std::string> SceneAssignments(const SuiteSequence& sequence,
                                          const GridPoint& parameters);

// What to open for a cell whose sequence is in `folder`; files of boxes and labels are below
// `data`, but for `boxes` of a detector (empty: open it without).
SequenceRequest RequestOf(const Cell& cell, const std::filesystem::path& folder,
                          const std::filesystem::path& data, const std::string& boxes);

// The level of the scene's own detector that a sequence names; empty: none.
std::string DetectorLevel(const SuiteSequence& sequence);

// Classes of detections that count: the sequence's, else RigidClasses().
std::vector<std::string> ClassesOf(const SuiteSequence& sequence);

// The files of a cell of another system, below `data`; those that come with the program are put
// below the cache folder.
SystemFiles SystemFilesOf(const Suite& suite, const Cell& cell, const std::filesystem::path& data,
                          const std::filesystem::path& cache);

OracleSwitches OracleOf(const std::vector<std::string>& switches);

}  // namespace cvo
