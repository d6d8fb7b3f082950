// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cvo {

// Of this machine; "unknown" where it does not tell.
std::string HostName();

}  // namespace cvo
