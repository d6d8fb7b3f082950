// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/scene/description.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/base/task_pool.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "synth/models/model.h"
#include "synth/motion/motion.h"
#include "synth/scene/world.h"

namespace cvo::synth {
namespace {

struct SceneText {
  std::string text;
  std::string where;
};

SceneText FindScene(const std::string& scene) {
  std::vector<std::string> names;
  for (const ShippedScene& shipped : ShippedScenes()) {
    if (shipped.name == scene) return {shipped.text, "scene " + scene};
    names.push_back(shipped.name);
  }
  const std::filesystem::path file = scene;
  if (std::filesystem::is_regular_file(file)) return {ReadFileBytes(file), scene};
  ThrowError("scene " + Quoted(scene), "neither a shipped scene nor a file",
             "a JSON file or " + OneOfKnown(scene, names));
}

// Returns the value of one key of a path. A key that is missing in an object is created, so that
// strict parsing reports it if it is unknown.
Json& Child(Json& parent, const std::string& key, const std::string& where) {
  if (parent.is_object()) return parent[key];
  if (!parent.is_array())
    ThrowError(where, "'" + key + "' within a value that has no parts", "a path of keys");
  const auto index = ParseInteger(key);
  if (!index || *index < 0 || *index >= static_cast<std::int64_t>(parent.size())) {
    ThrowError(where, "'" + key + "'", StrCat("an index below ", parent.size()));
  }
  return parent[static_cast<std::size_t>(*index)];
}

void Assign(Json& scene, const std::string& assignment) {
  const std::string where = "--set " + assignment;
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string::npos) {
    ThrowError(where, "no PATH=VALUE", "PATH=VALUE, for example objects.0.size_m=0.6");
  }
  Json* value = &scene;
  const std::string path = assignment.substr(0, equals);
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    value = &Child(*value, path.substr(start, end - start), where);
    if (value->is_null() && end < path.size()) *value = Json::object();
    start = end + 1;
  }
  const std::string text = assignment.substr(equals + 1);
  try {
    *value = ParseJson(text, where);
  } catch (const Error&) {
    *value = text;  // a word needs no quotes
  }
}

// Sorts keys and gives numbers a unique form, so that equal meaning gives equal text.
nlohmann::json Canonical(const Json& value) {
  if (value.is_object()) {
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [key, element] : value.items()) object[key] = Canonical(element);
    return object;
  }
  if (value.is_array()) {
    nlohmann::json array = nlohmann::json::array();
    for (const Json& element : value) array.push_back(Canonical(element));
    return array;
  }
  // Keep integers: doubles cannot represent all seeds beyond 2^53.
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) {
    const double number = value.get<double>();
    const auto whole = static_cast<std::int64_t>(std::clamp(number, -1e15, 1e15));
    if (static_cast<double>(whole) == number) return whole;
    return number;
  }
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>();
  return nullptr;
}

constexpr float kBlock_m = 24.0F;  // a room usually fits into the block around the origin

struct Block {
  int x;
  int y;
};

Block BlockAround(const Eigen::Vector3f& point) {
  const auto index = [](float v) { return static_cast<int>(std::floor(v / kBlock_m + 0.5F)); };
  return {index(point.x()), index(point.y())};
}

// Adds meshes, textures and drawables to a world. Parts that share an image in memory share a
// texture.
class Scenery {
 public:
  explicit Scenery(World& world) : world_(world) {}

  void AddBody(const Model& model, int body) {
    for (const Part& part : model.parts) {
      world_.drawables.push_back({static_cast<int>(world_.meshes.size()), Texture(part.texture),
                                  body, part.gloss, part.casts_shadow});
      world_.meshes.push_back(part.mesh);
    }
  }

  // Merges parts of equal appearance into one mesh per block of ground. There are few draw calls,
  // but blocks out of view can still be culled and near blocks drawn first.
  void AddBackground(const Part& part, const RigidTransform& world_from_part) {
    const int texture = Texture(part.texture);
    const Eigen::Matrix3f rotation = world_from_part.RotationMatrix().cast<float>();
    const Eigen::Vector3f translation = world_from_part.translation().cast<float>();
    std::vector<Vertex> vertices;
    for (const Vertex& v : part.mesh.vertices) {
      vertices.push_back({rotation * v.position + translation, rotation * v.normal, v.uv});
    }
    // Index of each vertex in the mesh of each block.
    std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> moved;
    const std::vector<std::uint32_t>& indices = part.mesh.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      const Eigen::Vector3f middle =
          (vertices[indices[i]].position + vertices[indices[i + 1]].position +
           vertices[indices[i + 2]].position) /
          3.0F;
      const Block block = BlockAround(middle);
      const std::size_t number =
          MeshFor({texture, part.gloss, part.casts_shadow, block.x, block.y});
      Mesh& mesh = world_.meshes[number];
      for (std::size_t k = i; k < i + 3; ++k) {
        const auto [at, is_new] = moved.try_emplace(
            {number, indices[k]}, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (is_new) mesh.vertices.push_back(vertices[indices[k]]);
        mesh.indices.push_back(at->second);
      }
    }
  }

 private:
  // Texture, gloss, shadow casting, x and y of the block.
  using Likeness = std::tuple<int, float, bool, int, int>;

  int Texture(const cv::Mat& texture) {
    const auto [known, is_new] =
        textures_.try_emplace(texture.data, static_cast<int>(world_.textures.size()));
    if (is_new) world_.textures.push_back(texture);
    return known->second;
  }

  std::size_t MeshFor(const Likeness& likeness) {
    const auto [merged, is_new] = background_.try_emplace(likeness, world_.meshes.size());
    if (is_new) {
      const auto& [texture, gloss, casts_shadow, x, y] = likeness;
      world_.drawables.push_back(
          {static_cast<int>(merged->second), texture, 0, gloss, casts_shadow});
      world_.meshes.emplace_back();
      world_.meshes.back().two_sided = false;  // never seen from behind
    }
    return merged->second;
  }

  World& world_;
  // Indices of textures by the address of their pixels, numbered in the order of the parts.
  std::map<const unsigned char*, int> textures_;
  std::map<Likeness, std::size_t> background_;
};

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

SceneDescription::SceneDescription(Json json, std::string where)
    : json_(std::move(json)),
      where_(std::move(where)),
      parts_(std::make_shared<SceneParts>(ParseScene(json_, where_))) {}

SceneDescription SceneDescription::Parse(Json json, const std::string& where,
                                         const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) Assign(json, assignment);
  return {std::move(json), where};
}

SceneDescription SceneDescription::Load(const std::string& scene,
                                        const std::vector<std::string>& assignments) {
  const SceneText found = FindScene(scene);
  Json json = ParseJson(found.text, found.where);
  for (const std::string& assignment : assignments) Assign(json, assignment);
  return {std::move(json), found.where};
}

std::string RenderKeyText(const SceneDescription& scene) {
  nlohmann::json key = Canonical(scene.json());
  const nlohmann::json blur = Canonical(scene.sensor()).value("motion_blur", nlohmann::json());
  for (const char* other : {"name", "about", "seed", "detector", "sensor"}) key.erase(other);
  if (!blur.is_null()) key["sensor"]["motion_blur"] = blur;
  return key.dump(1) + "\n";
}

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
