// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/jobs/engine.h"
#include "experiments/jobs/slurm/slurm_array.h"

namespace cvo {

// Returns how a task ended whose script recorded its end.
TaskEnd EndByCode(const Task& task, const SlurmEnd& end);

// Returns how a task ended that was ended by Slurm ("CANCELLED", "TIMEOUT", ...), or that left the
// queue without a state (`state` is empty). `words` is the last line that Slurm wrote about it, and
// may be empty.
TaskEnd EndByState(const std::string& state, const std::string& words);

}  // namespace cvo
