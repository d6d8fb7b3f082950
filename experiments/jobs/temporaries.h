// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace cvo {

// Removes the temporary files that killed processes left in a folder (WriteFilesAtomically); not
// those in folders within. Only where nobody else writes. What cannot be removed stays.
void RemoveTemporaries(const std::filesystem::path& folder);

}  // namespace cvo
