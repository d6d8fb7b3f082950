// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/figures/figure.h"

namespace cvo::reports {

// One figure as a separate page: it shows values under the pointer and allows zooming. The page
// opens from disk and needs no network.
std::string InteractivePage(const Figure& figure);

}  // namespace cvo::reports
