// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/files/text_file.h"
#include "core/record/timing.h"
#include "experiments/record/run_result.h"

namespace cvo {

// Where and when a run was made. None of this is in a result.
struct RunContext {
  std::string job;
  std::string date;  // UTC, ISO 8601
  std::string host;
  std::string cpu;
  int threads = 1;
  reports::RunPaths paths;
  double peak_memory_mb = 0.0;  // 10^6 bytes, of the whole process
};

// Returns date, host, CPU and peak memory of the running process. The other fields are left empty.
RunContext ThisProcess();

// Writes timing.json: wall time per frame by stage in ms, frames per second, and the context.
void WriteTimingFile(const RunResult& run, const RunContext& context, const TextSink& sink);

}  // namespace cvo
