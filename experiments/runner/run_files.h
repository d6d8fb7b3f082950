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

// What a run may write to its folder: result.json, timing.json, camera.tum, camera.kitti,
// objects.csv, tracks.kitti, on request landmarks.csv, and clusters/<id>.tum.
std::vector<std::string> RunFileNames();

// landmarks.csv in the folder with its header: rows are added while the run goes on, since all of
// them are many times the memory of a run.
StagedFile BeginLandmarks(const std::filesystem::path& folder);

// Writes them to a folder that exists: all complete, or none (see StagedFiles). Files of
// an earlier run that this one does not have are removed.
void WriteRunFiles(const std::filesystem::path& folder, const RunRecord& record,
                   const RunContext& context, std::optional<StagedFile> landmarks = {});

}  // namespace cvo
