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

// A scene file as read: strict JSON with `--set` assignments applied, every key and value checked.
// `seed`, `sensor` and `detector` do not change what is drawn.
class SceneDescription {
 public:
  // A shipped scene's name or the path of a JSON file; "sensor.read_noise=0",
  // "objects.1.size_m=..." with JSON values. Throws Error naming file and key.
  static SceneDescription Load(const std::string& scene,
                               const std::vector<std::string>& assignments);
  // Mesh files are meant relative to the working folder.
  static SceneDescription Parse(Json json, const std::string& where,
                                const std::vector<std::string>& assignments = {});

  const Json& json() const { return json_; }  // as given, assignments applied
  const std::string& where() const { return where_; }
  const SceneParts& parts() const { return *parts_; }
  std::string name() const { return parts_->name; }
  std::string about() const { return parts_->about; }
  std::uint64_t seed() const { return parts_->seed; }
  // Empty objects where the scene does not say; for synth/write to read strictly.
  const Json& sensor() const { return parts_->sensor; }
  const Json& detector() const { return parts_->detector; }

 private:
  SceneDescription(Json json, std::string where, const std::filesystem::path& folder);

  Json json_;
  std::string where_;
  std::shared_ptr<const SceneParts> parts_;
};

// Everything that decides what is drawn, as text for a cache key: keys sorted, mesh files by the
// content of all files of that stem. Without name, about, seed, detector and sensor, but with
// sensor.motion_blur.
std::string RenderKeyText(const SceneDescription& scene);

// Throws Error for an impossible scene: bodies through each other or through a wall, a camera
// inside something, a body that is never in front of the camera.
World BuildWorld(const SceneDescription& scene, int threads);

}  // namespace cvo::synth
