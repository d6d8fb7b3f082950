// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/import/import_stereo.h"

namespace cvo {

// The sequence that ImportStereo makes, once: below `cache`, under the hash of everything that it
// is made of; made again where a file of it has changed. Throws Error as ImportStereo does.
std::filesystem::path ImportIntoCache(
    const StereoImport& request, const std::filesystem::path& cache,
    const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace cvo
