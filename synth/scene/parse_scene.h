// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "synth/scene/object_reader.h"
#include "synth/scene/scene_parts.h"

namespace cvo::synth {

// Parses a scene file. Paths of mesh files are relative to `folder`. Throws Error naming `where`
// and the key.
SceneParts ParseScene(const Json& json, const std::string& where,
                      const std::filesystem::path& folder);

// Parse the paths of bodies and of the camera.
RouteDescription ParseRoute(ObjectReader route);  // without bottom_m and heading
PathDescription ParsePath(ObjectReader path);
CameraDescription ParseCamera(ObjectReader camera);

}  // namespace cvo::synth
