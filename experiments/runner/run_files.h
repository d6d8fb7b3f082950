// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/atomic_file.h"
#include "experiments/record/result_file.h"
#include "experiments/record/timing_file.h"

namespace cvo {

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
