// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo {

// Names of all metrics that a result can have (ScoreRun), refined and causal.
std::vector<std::string> KnownMetrics();

}  // namespace cvo
