// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/files/json/json.h"
#include "core/geometry/stereo_camera.h"
#include "synth/models/make_model.h"
#include "synth/models/surroundings.h"
#include "synth/motion/path_description.h"
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

}  // namespace cvo::synth
