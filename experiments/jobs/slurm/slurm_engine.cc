// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/slurm/slurm_engine.h"

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/jobs/slurm/slurm_array.h"
#include "experiments/jobs/slurm/slurm_client.h"
#include "experiments/jobs/slurm/slurm_run.h"

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
  if (!tasks.empty()) SlurmRun(options_, tasks, hooks).RunToCompletion();
}

void SlurmEngine::KeepOnly(const std::set<std::string>& names, const EngineHooks& hooks) {
  const std::vector<SlurmArray> arrays = ReadSlurmArrays(options_.folder);
  if (arrays.empty()) return;
  std::vector<std::string> array_names;
  for (const SlurmArray& array : arrays) array_names.push_back(array.name);
  const SlurmClient client(options_.patience_s, hooks);
  const SlurmQueue queue = client.Queue(array_names);
  std::vector<std::string> strangers;
  for (const SlurmArray& array : arrays) {
    bool alive = false;
    for (std::size_t number = 0; number < array.entries.size(); ++number) {
      const auto found = queue.find({array.name, number});
      if (found == queue.end() || IsTaskFinished(found->second.state)) continue;
      alive = true;
      if (names.contains(array.entries[number].name)) continue;
      strangers.push_back(StrCat(found->second.job, "_", number));
    }
    if (!alive) RemoveSlurmArray(array);
  }
  client.Cancel(strangers);
  if (strangers.empty()) return;
  hooks.notice(
      StrCat("slurm: cancelled tasks that an earlier run submitted and that are no longer needed: ",
             Counted(strangers.size(), "task")));
}

}  // namespace cvo
