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

// Returns the request that opens a cell's sequence, which is in `folder`. Files of boxes and labels
// are below `data`, except `boxes`, which a detector wrote (empty: open the sequence without them).
SequenceRequest RequestOf(const Cell& cell, const std::filesystem::path& folder,
                          const std::filesystem::path& data, const std::string& boxes);

// Returns the level of the scene's own detector that the sequence names, or an empty string if
// there is none.
std::string DetectorLevel(const SuiteSequence& sequence);

// Returns the classes of detections to use: the sequence's own, or RigidClasses() if it has none.
std::vector<std::string> ClassesOf(const SuiteSequence& sequence);

// Returns the files of a cell of another system, below `data`. Trajectories shipped with the
// program are written below the cache folder.
SystemFiles SystemFilesOf(const Suite& suite, const Cell& cell, const std::filesystem::path& data,
                          const std::filesystem::path& cache);

OracleSwitches OracleOf(const std::vector<std::string>& switches);

}  // namespace cvo
