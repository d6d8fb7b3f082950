// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cvo {

// Checks that OpenOutput cannot make: whether an output would be mixed with other results or with
// the user's own files. The first three throw UsageError, before any work is done.

// Throws if the output is, lies in or contains a folder of `inputs`, or is the folder of a file of
// `inputs`. Paths that are empty or do not exist are ignored.
void CheckApartFrom(const std::vector<std::filesystem::path>& inputs,
                    const std::filesystem::path& output);

// For the output of a run: throws if it is the folder of a suite or lies in the folder of another
// run.
void CheckPlaceOfRun(const std::filesystem::path& output);

// For the output of a suite: throws if it is the folder of a run or of a suite with another name. A
// plan.json that cannot be read counts as none.
void CheckPlaceOfSuite(const std::filesystem::path& output, const std::string& suite);

// For a folder that is read as a suite's folder: throws Error if it contains the suites of a
// collection instead.
void CheckNoCollection(const std::filesystem::path& folder);

}  // namespace cvo
