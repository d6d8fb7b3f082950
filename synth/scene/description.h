// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/files/json.h"
#include "synth/scene/world.h"

namespace cvo::synth {

// A scene file as read: strict JSON with `--set` assignments applied, every key and value checked.
// What `seed`, `sensor` and `detector` say does not touch what is drawn.
class SceneDescription {
 public:
  // A shipped scene's name or the path of a JSON file; "sensor.read_noise=0",
  // "objects.1.size_m=..." with JSON values. Throws Error naming file and key.
  static SceneDescription Load(const std::string& scene,
                               const std::vector<std::string>& assignments);
  static SceneDescription Parse(const Json& json, const std::string& where);

  const Json& json() const { return json_; }  // as given, assignments applied
  std::string name() const;
  std::uint64_t seed() const;

 private:
  Json json_;
  std::string where_;
};

// Throws Error for a scene that cannot be: bodies through each other or through a wall, a camera
// inside something, a body that is never in front of the camera.
World BuildWorld(const SceneDescription& scene, int threads);

}  // namespace cvo::synth
