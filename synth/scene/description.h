// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/files/json/json.h"
#include "core/geometry/stereo_camera.h"
#include "synth/models/model.h"
#include "synth/motion/motion.h"
#include "synth/scene/object_reader.h"
#include "synth/scene/world.h"

namespace cvo::synth {

// The content of a scene file, with every key checked. synth/README.md gives units and meaning.
// `where` names file and key, for errors that are detected only when the scene is built.

struct ObjectDescription {
  std::string where;
  std::string name;
  std::string category;
  ModelDescription model;
  PathDescription path;
};

struct SceneParts {
  std::string name;
  std::string about;
  std::uint64_t seed = 0;
  std::uint64_t look_seed = 0;
  StereoCamera rig;
  RigError rig_error;
  int frames = 0;
  double rate_hz = 0.0;
  std::variant<RoomDescription, StreetDescription> surroundings;
  Light light;
  double texture_contrast = 1.0;  // scales all textures about their mean colour
  CameraDescription camera;
  std::vector<ObjectDescription> objects;  // one for each copy
  Json sensor = Json::object();
  Json detector = Json::object();

  double Duration_s() const { return frames / rate_hz; }
};

// A parsed scene file: strict JSON with `--set` assignments applied and every key and value
// checked. `seed`, `detector` and `sensor`, except `sensor.motion_blur`, do not affect the render.
class SceneDescription {
 public:
  // Loads a shipped scene by name or a JSON file by path. Assignments are PATH=VALUE with JSON
  // values or bare words, such as "sensor.read_noise=0" or "objects.1.size_m=...". Throws Error
  // naming file and key.
  static SceneDescription Load(const std::string& scene,
                               const std::vector<std::string>& assignments);
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
  SceneDescription(Json json, std::string where);

  Json json_;
  std::string where_;
  std::shared_ptr<const SceneParts> parts_;
};

// Returns everything that determines the render, as text for a cache key with sorted keys. Leaves
// out name, about, seed, detector and sensor, but keeps sensor.motion_blur.
std::string RenderKeyText(const SceneDescription& scene);

// Builds the world of a scene. Throws Error for an impossible scene: a body passes through another
// body, furniture or a wall, the camera is inside something, or a body is never in the camera's
// view.
World BuildWorld(const SceneDescription& scene, int threads);

// Parses a scene file. Throws Error naming `where` and the key.
SceneParts ParseScene(const Json& json, const std::string& where);

// Parse the paths of bodies and of the camera.
RouteDescription ParseRoute(ObjectReader route);  // without bottom_m and heading
PathDescription ParsePath(ObjectReader path);
CameraDescription ParseCamera(ObjectReader camera);

struct ShippedScene {
  std::string name;  // the `name` in `text`
  std::string text;  // JSON
};

// Returns the scene files of synth/scenes. They are compiled in, so that the program does not
// depend on its location.
std::vector<ShippedScene> ShippedScenes();

}  // namespace cvo::synth
