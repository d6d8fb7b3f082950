// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "experiments/jobs/engine.h"

namespace cvo {

// Quotes a text as one word of a POSIX shell, whatever bytes it contains.
std::string ShellQuoted(const std::string& text);

// Returns an sh script that runs the task with number $1, or $SLURM_ARRAY_TASK_ID if there is none,
// within its limits and with its output in its log. Once the task has ended, and not before,
// `folder`/end/<number> contains "<exit code> <start> <end>" (times in seconds). A task that is
// started again removes that file first.
std::string SlurmScript(std::span<const Task> tasks, const std::filesystem::path& folder);

}  // namespace cvo
