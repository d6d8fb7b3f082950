// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/json/json.h"
#include "reports/runs/run_detail.h"

namespace cvo::reports {

// The content of truth.json, for the frames that result.json lists. Frames in the file are indices
// into these.
struct RunTruth {
  std::vector<std::optional<Pose>> camera;  // one per frame
  std::vector<BodyDetail> bodies;
};

// Each throws Error naming the file, and the field or line, if the file is damaged.
RunTruth ReadTruthFile(const std::filesystem::path& file, const std::vector<CameraFrame>& frames);
std::vector<ClusterRow> ReadClusterTable(const std::filesystem::path& file);

}  // namespace cvo::reports
