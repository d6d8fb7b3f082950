// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "experiments/jobs/engine.h"

namespace cvo {

// One word of a POSIX shell, whatever bytes it holds.
std::string ShellQuoted(const std::string& text);

// A script for sh that runs task number $1, else $SLURM_ARRAY_TASK_ID, of these: within its limits,
// output to its log. When the task has ended, and not before, `folder`/end/<number> holds "<exit
// code> <start> <end>" (seconds); a task that starts again removes it first.
std::string SlurmScript(std::span<const Task> tasks, const std::filesystem::path& folder);

}  // namespace cvo
