// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace cvo::reports {

// Files that the program embeds in its pages. Each can be put between its tags as it is.
std::string_view PlotlyScript();
std::string_view PlotlyLicence();  // plain text
std::string_view AppScript();
std::string_view AppStyle();

// A Content-Security-Policy that allows these two scripts to run and nothing else, not even access
// to the network.
std::string_view ContentPolicy();

}  // namespace cvo::reports
