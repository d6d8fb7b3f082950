// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/atomic_file.h"
#include "core/files/text_file.h"
#include "core/record/run_summary.h"
#include "experiments/runner/result_file.h"
#include "experiments/runner/run_result.h"

namespace cvo {

// Returns date, host, CPU, peak memory and number of CPUs of the running process, the head of its
// timing.json.
reports::TimingData ThisProcess();

// Writes timing.json: the head with wall time per frame by stage in ms, and frames per second.
void WriteTimingFile(const RunResult& run, reports::TimingData timing, const TextSink& sink);

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
                   const reports::TimingData& timing, std::optional<StagedFile> landmarks = {});

}  // namespace cvo
