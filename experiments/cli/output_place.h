// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cvo {

// What OpenOutput cannot know: with whose results or own files a folder would be mixed. The first
// three throw UsageError, before any work.

// If the output is, is in, or holds a folder of `inputs`, or is the folder of a file of them. Empty
// paths and those that do not exist are left out.
void CheckApartFrom(const std::vector<std::filesystem::path>& inputs,
                    const std::filesystem::path& output);

// For the output of a run: if it holds a suite, or is in the folder of another run.
void CheckPlaceOfRun(const std::filesystem::path& output);

// For the output of a suite: if it holds a run, or a suite of another name. A plan.json that cannot
// be read counts as none.
void CheckPlaceOfSuite(const std::filesystem::path& output, const std::string& suite);

// For a folder that is read as that of a suite: Error if it holds those of a collection instead.
void CheckNoCollection(const std::filesystem::path& folder);

}  // namespace cvo
