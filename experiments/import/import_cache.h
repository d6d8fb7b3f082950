// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/import/import_stereo.h"

namespace cvo {

// Returns the folder of the sequence that ImportStereo makes. The sequence is made only once, below
// `cache`, under the hash of all its inputs, and again if one of its files has changed. Throws
// Error as ImportStereo.
std::filesystem::path ImportIntoCache(
    const StereoImport& request, const std::filesystem::path& cache,
    const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace cvo
