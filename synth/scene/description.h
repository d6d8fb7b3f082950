// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "synth/scene/scene_parts.h"
#include "synth/scene/world.h"

namespace cvo::synth {

// A parsed scene file: strict JSON with `--set` assignments applied and every key and value
// checked. `seed`, `detector` and `sensor`, except `sensor.motion_blur`, do not affect the render.
class SceneDescription {
 public:
  // Loads a shipped scene by name or a JSON file by path. Assignments are PATH=VALUE with JSON
  // values or bare words, such as "sensor.read_noise=0" or "objects.1.size_m=...". Throws Error
  // naming file and key.
  static SceneDescription Load(const std::string& scene,
                               const std::vector<std::string>& assignments);
  // Paths of mesh files are relative to the working directory.
  static SceneDescription Parse(Json json, const std::string& where,
                                const std::vector<std::string>& assignments = {});

  const Json& json() const { return json_; }  // as given, with the assignments applied
  const std::string& where() const { return where_; }
  const SceneParts& parts() const { return *parts_; }
  std::string name() const { return parts_->name; }
  std::string about() const { return parts_->about; }
  std::uint64_t seed() const { return parts_->seed; }
  // Sections of the scene, empty objects if it has none. synth/write parses and checks their
  // content.
  const Json& sensor() const { return parts_->sensor; }
  const Json& detector() const { return parts_->detector; }

 private:
  SceneDescription(Json json, std::string where, const std::filesystem::path& folder);

  Json json_;
  std::string where_;
  std::shared_ptr<const SceneParts> parts_;
};

// Returns everything that determines the render, as text for a cache key: keys are sorted, and a
// mesh file is represented by the content of all files with its stem. Leaves out name, about, seed,
// detector and sensor, but keeps sensor.motion_blur.
std::string RenderKeyText(const SceneDescription& scene);

// Builds the world of a scene. Throws Error for an impossible scene: a body passes through another
// body, furniture or a wall, the camera is inside something, or a body is never in the camera's
// view.
World BuildWorld(const SceneDescription& scene, int threads);

}  // namespace cvo::synth
