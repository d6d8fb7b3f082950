// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/base/task_pool.h"
#include "synth/motion/camera_motion.h"
#include "synth/motion/paths.h"
#include "synth/scene/check_world.h"
#include "synth/scene/description.h"
#include "synth/scene/scenery.h"

namespace cvo::synth {
namespace {

struct Models {
  Surroundings surroundings;
  std::vector<Model> objects;
};

Surroundings MakeSurroundings(const SceneParts& scene, Rng look) {
  const RoomDescription* room = std::get_if<RoomDescription>(&scene.surroundings);
  if (room != nullptr) return MakeRoom(*room, look);
  return MakeStreet(std::get<StreetDescription>(scene.surroundings), look);
}

// Makes every model from its own random stream, so that an additional object changes no other.
// `where` names the scene.
Models MakeModels(const SceneParts& scene, const std::string& where, TaskPool& pool) {
  Models models;
  models.objects.resize(scene.objects.size());
  pool.ParallelFor(1 + static_cast<int>(scene.objects.size()), [&](int i) {
    const ObjectDescription* object = i == 0 ? nullptr : &scene.objects[i - 1];
    try {
      if (object == nullptr) {
        models.surroundings = MakeSurroundings(scene, Rng(scene.look_seed, "surroundings"));
      } else {
        Rng look(scene.look_seed, "object/" + object->name);
        models.objects[i - 1] = MakeModel(object->model, look);
      }
    } catch (const Error& error) {
      throw Error((object == nullptr ? where : object->where) + ", " + error.what());
    }
  });
  return models;
}

BodyShape ShapeOf(const Model& model) {
  const bool is_ball = model.shapes.size() == 1 && model.shapes[0].radius_m > 0.0;
  return {0.5 * model.size_m.z(), is_ball ? model.shapes[0].radius_m : 0.0};
}

std::vector<Solid> MakeSolids(const SceneParts& scene, const World& world, const Models& models) {
  constexpr double kCameraRadius_m = 0.15;
  std::vector<Solid> solids;
  CollisionShape camera;
  camera.radius_m = kCameraRadius_m;
  solids.push_back({"the camera", {camera}, world.camera, {}});
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    solids.push_back({world.bodies[i].name, models.objects[i].shapes, world.bodies[i].motion, {}});
  }
  const bool indoors = std::holds_alternative<RoomDescription>(scene.surroundings);
  for (const PlacedModel& placed : models.surroundings.placed) {
    const Eigen::Vector3d at = placed.world_from_model.translation();
    const auto tenths = [](double value) { return std::round(10.0 * value) / 10.0; };
    solids.push_back({StrCat(indoors ? "furniture" : "roadside", " at (", tenths(at.x()), ", ",
                             tenths(at.y()), ")"),
                      placed.model.shapes, nullptr, placed.world_from_model});
  }
  return solids;
}

std::vector<Eigen::Vector4d> WallsAndFloor(const Surroundings& surroundings) {
  std::vector<Eigen::Vector4d> walls = surroundings.walls;
  const bool has_floor = std::any_of(walls.begin(), walls.end(),
                                     [](const Eigen::Vector4d& wall) { return wall[2] > 0.99; });
  if (!has_floor) walls.emplace_back(0.0, 0.0, 1.0, 0.0);
  return walls;
}

// Scales all colours about the mean colour of their texture.
void ScaleContrast(double contrast, World& world) {
  if (contrast == 1.0) return;
  for (cv::Mat& texture : world.textures) {
    const cv::Scalar mean = cv::mean(texture);
    cv::Mat scaled = texture.clone();  // parts may share the original
    for (int row = 0; row < scaled.rows; ++row) {
      for (int column = 0; column < scaled.cols; ++column) {
        auto& pixel = scaled.at<cv::Vec3b>(row, column);
        for (int k = 0; k < 3; ++k) {
          pixel[k] = cv::saturate_cast<unsigned char>(mean[k] + contrast * (pixel[k] - mean[k]));
        }
      }
    }
    texture = scaled;
  }
}

}  // namespace

World BuildWorld(const SceneDescription& description, int threads) {
  const SceneParts& scene = description.parts();
  World world;
  world.name = scene.name;
  world.rig = scene.rig;
  world.rig.Check();
  world.rig_error = scene.rig_error;
  world.frames = scene.frames;
  world.rate_hz = scene.rate_hz;
  world.light = scene.light;
  world.light.direction.normalize();
  world.camera = MakeCameraMotion(scene.camera, scene.Duration_s(), scene.look_seed);
  TaskPool pool(threads);
  const Models models = MakeModels(scene, description.where(), pool);
  Scenery scenery(world);
  for (const Part& part : models.surroundings.shell) scenery.AddBackground(part, {});
  for (const PlacedModel& placed : models.surroundings.placed) {
    for (const Part& part : placed.model.parts) {
      scenery.AddBackground(part, placed.world_from_model);
    }
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const ObjectDescription& object = scene.objects[i];
    const Model& model = models.objects[i];
    const int id = static_cast<int>(i) + 1;
    world.bodies.push_back({id, object.name, object.category, model.size_m,
                            MakeMotion(object.path, ShapeOf(model), scene.Duration_s())});
    scenery.AddBody(model, id);
  }
  ScaleContrast(scene.texture_contrast, world);
  CheckCollisions(MakeSolids(scene, world, models), WallsAndFloor(models.surroundings),
                  scene.Duration_s(), threads, description.where());
  CheckInView(world, description.where());
  return world;
}

}  // namespace cvo::synth
