// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "core/files/json/json.h"
#include "core/files/text_sink.h"

namespace cvo {

// Writes `object`, which must not be empty, to `sink` in the format of DumpJson, with one
// additional member `key` after its own members and before those of `behind`. This member is an
// array: `next` sets each row in turn until it returns false. Only one row at a time is in memory.
void DumpJsonWithRows(const Json& object, const std::string& key,
                      const std::function<bool(Json& row)>& next, const TextSink& sink,
                      const Json& behind = Json::object());

}  // namespace cvo
