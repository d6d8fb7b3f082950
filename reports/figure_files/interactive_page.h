// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/figures/figure.h"

namespace cvo::reports {

// One figure as a page of its own: values are shown under the pointer, parts can be enlarged. It
// opens from disk and needs no network.
std::string InteractivePage(const Figure& figure);

}  // namespace cvo::reports
