// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/files/json.h"
#include "experiments/metrics/object_scores.h"

namespace cvo {

// One reports::BodyRow per body, for means over bodies of several runs, with its position errors
// frame by frame, which pair one variant with another.
Json BodiesToJson(const std::vector<BodyScore>& bodies);

}  // namespace cvo
