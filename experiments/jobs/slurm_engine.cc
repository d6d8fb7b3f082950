// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/slurm_engine.h"

#include "core/base/error.h"
#include "experiments/jobs/slurm_run.h"

namespace cvo {

void SlurmOptions::Check() const {
  if (!folder.is_absolute()) {
    ThrowError("SlurmOptions: folder", folder.string(), "an absolute path");
  }
  for (const std::string& flag : sbatch_flags) {
    if (flag.size() > 1 && flag.front() == '-') continue;
    ThrowError("flag for sbatch", flag, "a flag in one word, such as --partition=short");
  }
  if (at_once < 0) ThrowError("SlurmOptions: at_once", StrCat(at_once), "0 or more");
  if (!(poll_s > 0.0)) ThrowError("SlurmOptions: poll_s", StrCat(poll_s), "seconds above 0");
}

SlurmEngine::SlurmEngine(SlurmOptions options) : options_(std::move(options)) { options_.Check(); }

void SlurmEngine::Run(std::span<const Task> tasks, const EngineHooks& hooks) {
  if (!tasks.empty()) SlurmRun(options_, tasks, hooks).ToTheEnd();
}

}  // namespace cvo
