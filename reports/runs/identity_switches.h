// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/runs/run_detail.h"

namespace cvo::reports {

// A body's landmarks are of another cluster than the last time they were of one.
struct IdentitySwitch {
  int frame = 0;
  int body = 0;
  std::int64_t from = 0;  // ids of clusters
  std::int64_t to = 0;
};

// As the metric object_id_switches counts them, over visible frames, from a run's landmarks.csv;
// empty optional where there is no such file. Throws Error for one that is damaged.
[[nodiscard]] std::optional<std::vector<IdentitySwitch>> ReadIdentitySwitches(
    const std::filesystem::path& run_folder, const std::vector<BodyDetail>& bodies);

}  // namespace cvo::reports
