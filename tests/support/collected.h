// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/files/text_file.h"

namespace cvo::test {

// Returns the text that a writer passes to its sink, e.g. Collected(WriteObjectTable, run).
template <typename Write, typename... Arguments>
std::string Collected(const Write& write, const Arguments&... arguments) {
  std::string text;
  write(arguments..., [&text](std::string_view part) { text += part; });
  return text;
}

}  // namespace cvo::test
