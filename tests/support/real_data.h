// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "core/base/error.h"

namespace cvo::test {

// Returns the folder of real data named by CLUSTERVO_DATA; empty if the variable is unset or empty.
// Throws if it names no existing folder, so that the test fails. Usage:
//   const auto data = test::RealData();
//   if (!data) GTEST_SKIP() << "CLUSTERVO_DATA is not set";
inline std::optional<std::filesystem::path> RealData() {
  const char* folder = std::getenv("CLUSTERVO_DATA");
  if (folder == nullptr || *folder == '\0') return std::nullopt;
  if (!std::filesystem::is_directory(folder)) {
    ThrowError("CLUSTERVO_DATA", folder, "an existing folder");
  }
  return folder;
}

}  // namespace cvo::test
