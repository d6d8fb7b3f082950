// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/record/result_file.h"
#include "experiments/record/timing_file.h"

namespace cvo {

// result.json, timing.json, camera.tum and camera.kitti.
std::vector<std::string> RunFileNames();

// Writes them to a folder that exists: all complete, or none. Throws Error.
void WriteRun(const std::filesystem::path& folder, const RunRecord& record,
              const RunContext& context);

}  // namespace cvo
