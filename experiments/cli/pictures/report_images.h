// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "reports/page/page_content.h"

namespace cvo {

// Gives the scenes of a page that want them the drawn left images of every `every`-th frame; 0: as
// many as fit into the page. A scene whose images are not there says why. `folder`: of the suite.
void AddSceneImages(const std::filesystem::path& folder, int every, reports::PageContent& content);

// Writes every drawn left image of every scene to `out`/images/<run>/, 640 pixels wide at most, and
// tells the scenes so. A scene whose images are not there is left as it is.
void WriteAllImages(const std::filesystem::path& folder, const std::filesystem::path& out,
                    reports::PageContent& content);

}  // namespace cvo
