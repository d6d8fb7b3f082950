// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/suite/suite.h"

namespace cvo {

// One point of a grid: path and value of every axis.
using GridPoint = std::vector<std::pair<std::string, Json>>;

// Values of an axis as a suite file has them: a list, or {"from", "to", "steps"} with a "scale"
// ("linear", "log"); six significant digits between the ends. Throws Error naming `where`.
std::vector<Json> ParseAxisValues(const Json& json, const std::string& where);

// All points, the last axis fastest. One at a time: first the point with every axis at its default,
// then each axis through its other values. Defaults are the variant's (empty: of any), those of
// "scene." axes the sequence's.
std::vector<GridPoint> GridPoints(const Suite& suite, const SuiteSequence& sequence,
                                  const std::string& variant);

// Whether the path is of a scene file; and its key there.
bool IsScenePath(const std::string& path);
std::string SceneKey(const std::string& path);
// The same of a sequence's perturbation.
bool IsPerturbPath(const std::string& path);
std::string PerturbKey(const std::string& path);
// Of the estimator.
bool IsOptionPath(const std::string& path);

}  // namespace cvo
