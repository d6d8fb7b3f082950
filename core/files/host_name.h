// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cvo {

// Name of this machine; "unknown" if it cannot be determined.
std::string HostName();

}  // namespace cvo
