// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace cvo {

// Receives a text part by part.
using TextSink = std::function<void(std::string_view part)>;

}  // namespace cvo
