// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/atomic_file.h"
#include "core/files/text_file.h"
#include "core/record/timing.h"
#include "experiments/runner/result_file.h"
#include "experiments/runner/run_result.h"

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

// Returns the names of what a run may write to its folder: result.json, timing.json, truth.json,
// camera.tum, camera.kitti, objects.csv, tracks.kitti, clusters/ with <id>.tum and, on request,
// landmarks.csv.
std::vector<std::string> RunFileNames();

// Starts landmarks.csv in the folder with its header. Rows are appended during the run, since all
// of them take many times the memory of a run.
StagedFile BeginLandmarks(const std::filesystem::path& folder);

// Writes these files to an existing folder: either all of them complete, or none (see StagedFiles).
// Removes files of an earlier run that this one does not have.
void WriteRunFiles(const std::filesystem::path& folder, const RunRecord& record,
                   const RunContext& context, std::optional<StagedFile> landmarks = {});

}  // namespace cvo
