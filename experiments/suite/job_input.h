// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/interface/options.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/oracle.h"
#include "experiments/runner/system_run.h"
#include "experiments/suite/suite.h"

namespace cvo {

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

// Returns all jobs of a suite before their input is located, ordered by sequence, then seed,
// parameters, oracle and variant.
std::vector<PlanJob> ExpandSuite(const Suite& suite);

// Returns the request that opens the job's sequence, which is in `job.folder`. Files of boxes and
// labels are below `data`, except `job.boxes`, which a detector wrote (empty: open the sequence
// without them).
SequenceRequest RequestOf(const Suite& suite, const PlanJob& job,
                          const std::filesystem::path& data);

// Returns the level of the scene's own detector that the sequence names, or an empty string if
// there is none.
std::string DetectorLevel(const SuiteSequence& sequence);

// Returns the classes of detections to use: the sequence's own, or RigidClasses() if it has none.
std::vector<std::string> ClassesOf(const SuiteSequence& sequence);

// Returns the files of a job of another system, below `data`. Trajectories shipped with the
// program are written below the cache folder.
SystemFiles SystemFilesOf(const Suite& suite, const PlanJob& job, const std::filesystem::path& data,
                          const std::filesystem::path& cache);

OracleSwitches OracleOf(const std::vector<std::string>& switches);

}  // namespace cvo
