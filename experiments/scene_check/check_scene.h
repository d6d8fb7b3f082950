// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiments/scene_check/report.h"

namespace cvo {

// Checks the files of a rendered scene against each other, using nothing but the contents of the
// folder. The report does not depend on the number of threads. A file that cannot be read is a
// failed check; throws Error only if the folder is not that of a rendered scene.
SceneCheckReport CheckScene(const std::filesystem::path& folder, int threads);

}  // namespace cvo
