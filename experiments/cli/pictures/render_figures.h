// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/atomic_file.h"
#include "reports/figures/figure.h"

namespace cvo {

// Renders each figure in the browser, as "<id>.svg" or "<id>.pdf"; `format` is "svg" or "pdf".
// Throws Error as Browser.
std::vector<NamedContent> RenderFigures(const std::vector<reports::Figure>& figures,
                                        const std::string& format);

}  // namespace cvo
