// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace cvo::reports {

std::string Base64(std::string_view bytes);

}  // namespace cvo::reports
