// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace cvo::reports {

// What the program carries for its pages. Each can stand between its tags as it is.
std::string_view PlotlyScript();
std::string_view PlotlyLicence();  // plain text
std::string_view AppScript();
std::string_view AppStyle();

// A Content-Security-Policy: these two scripts run, nothing else does, and there is no network.
std::string_view ContentPolicy();

}  // namespace cvo::reports
