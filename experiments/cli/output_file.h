// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace cvo {

// Writes a file that the user named, whole or not at all; makes its folder. Throws Error naming
// what is in the way.
void WriteOutputFile(const std::filesystem::path& file, const std::string& content);

}  // namespace cvo
