// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/jobs/engine.h"
#include "experiments/jobs/slurm/slurm_array.h"

namespace cvo {

// How a task ended whose program came to its end.
TaskEnd EndByCode(const Task& task, const SlurmEnd& end);

// How a task ended that Slurm ended ("CANCELLED", "TIMEOUT", ...), or that left the queue without a
// word (state is empty). `words`: the last line that Slurm wrote about it, may be empty.
TaskEnd EndByState(const std::string& state, const std::string& words);

}  // namespace cvo
