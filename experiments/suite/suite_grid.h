// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/suite/suite.h"

namespace cvo {

// One point of a grid: the path and value of every axis.
using GridPoint = std::vector<std::pair<std::string, Json>>;

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

// Whether the path refers to a scene file ("scene."), and its key there.
bool IsScenePath(const std::string& path);
std::string SceneKey(const std::string& path);
// The same for a sequence's perturbation ("perturb.").
bool IsPerturbPath(const std::string& path);
std::string PerturbKey(const std::string& path);
// Whether the path refers to an estimator option.
bool IsOptionPath(const std::string& path);

}  // namespace cvo
