// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "reports/page/page_content.h"

namespace cvo {

// Adds to each scene of a page that wants images the drawn left images of every `every`-th frame;
// 0: of as many as fit into the page. Removes scenes from the end of a page that leaves no room for
// images. A scene whose images are missing states the reason. `folder`: of the suite.
void AddSceneImages(const std::filesystem::path& folder, int every, reports::PageContent& content);

// Writes every drawn left image of every scene to `out`/images/<run>/, at most 640 pixels wide, and
// enters this folder in the scene. A scene whose images are missing states the reason.
void WriteAllImages(const std::filesystem::path& folder, const std::filesystem::path& out,
                    reports::PageContent& content);

}  // namespace cvo
