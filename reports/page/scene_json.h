// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/json.h"
#include "reports/page/page_content.h"

namespace cvo::reports {

// What the 3D view draws of a run. Positions are whole millimetres, three numbers after each other;
// frames of clusters and bodies are indices into "frames"; images are data URLs.
Json SceneJson(const PageScene& scene);

}  // namespace cvo::reports
