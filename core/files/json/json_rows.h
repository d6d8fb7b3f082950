// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "core/files/json/json.h"
#include "core/files/text_sink.h"

namespace cvo {

// As DumpJson of the object, not empty, with one member more behind its own and before those of
// `behind`: an array of what `next` sets its row to until it returns false. One row at a time is in
// memory.
void DumpJsonWithRows(const Json& object, const std::string& key,
                      const std::function<bool(Json& row)>& next, const TextSink& sink,
                      const Json& behind = Json::object());

}  // namespace cvo
