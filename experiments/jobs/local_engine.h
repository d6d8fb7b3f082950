// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/jobs/engine.h"

namespace cvo {

// Runs tasks as processes on this machine, at most `processes` at once. No process is left when Run
// returns or throws, or when this process is killed.
class LocalEngine : public Engine {
 public:
  explicit LocalEngine(int processes);

  // A task that cannot be started, or whose log cannot be written, is reported as ended with that
  // message. For a stopped task no hook is called. Throws Error if a task's program is not an
  // executable file.
  void Run(std::span<const Task> tasks, const EngineHooks& hooks) override;

 private:
  std::size_t processes_;
};

}  // namespace cvo
