// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/system_run.h"
#include "experiments/suite/suite.h"

// Programs of others that a suite runs.
namespace cvo {

std::vector<std::string> CalibrationForms();

// Throws Error naming `where` for a placeholder in a system's texts that seems misspelt.
void CheckPlaceholders(const SuiteSystem& system, const std::string& where);

// Makes the files in the commands of a suite file absolute. `folder` is that of the suite file;
// empty: it has been read before.
void ResolveCommands(const std::filesystem::path& folder, Json& suite);

// Returns `text` with the placeholders {sequence} and {seed} filled in.
std::string ForJob(const std::string& text, const PlanJob& job);

// Returns what identifies the program of a system: its command, with hashes in place of files, what
// its version command prints, and what it reads and writes. Throws Error for a program that cannot
// be run.
Json IdentifyProgram(const SuiteSystem& system);
// Adds what the program takes besides the content of the sequence.
Json WithInput(Json program, const SuiteSystem& system, const Sequence& sequence);
// Returns a key of the files that placeholders lead to.
std::string InputsKey(const Sequence& sequence, const std::string& content,
                      const std::vector<std::string>& classes);

// Runs the program of a job, with its output and timing.json in the job's `folder`, and returns the
// files that it should have written. Its images are links to those of the sequence, or written once
// below `inputs` if they are rectified or perturbed. Throws Error if the program fails.
SystemFiles RunProgram(const Suite& suite, const PlanJob& job, const Sequence& sequence,
                       const std::filesystem::path& inputs, const std::filesystem::path& folder);

}  // namespace cvo
