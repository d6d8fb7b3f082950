// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/runs/run_detail.h"

namespace cvo::reports {

// A frame in which a body's landmarks belong to another cluster than the last time they belonged to
// one.
struct IdentitySwitch {
  int frame = 0;
  int body = 0;
  std::int64_t from = 0;  // ids of clusters
  std::int64_t to = 0;
};

// Returns the switches as the metric object_id_switches counts them, over visible frames, from a
// run's landmarks.csv. Empty optional if there is no such file. Throws Error if it is damaged.
[[nodiscard]] std::optional<std::vector<IdentitySwitch>> ReadIdentitySwitches(
    const std::filesystem::path& run_folder, const std::vector<BodyDetail>& bodies);

}  // namespace cvo::reports
