// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/jobs/engine.h"

namespace cvo {

// Runs tasks as processes of this machine, at most so many at once. No process is left when Run
// returns or throws, nor when this process is killed.
class LocalEngine : public Engine {
 public:
  explicit LocalEngine(int processes);

  // A task whose log cannot be written, or that cannot be started, ended with that message. A task
  // that is stopped did not end: no hook is called. Throws Error for a program that is none.
  void Run(std::span<const Task> tasks, const EngineHooks& hooks) override;

 private:
  std::size_t processes_;
};

}  // namespace cvo
