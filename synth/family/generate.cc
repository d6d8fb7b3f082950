// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "synth/family/family.h"
#include "synth/motion/motion.h"
#include "synth/scene/description.h"

namespace cvo::synth {
namespace {

constexpr int kLayoutTries = 200;  // crowded streets need more than 20
constexpr int kBodyTries = 60;

// A group of bodies, as listed in the layout of a family.
struct Group {
  std::string where;
  int count = 0;
  double in_view = 0.0;
  Json body;  // with draws
};

Eigen::Vector3d SizeOf(ObjectReader& keys) {
  constexpr Range kSize = {0.01, 200.0};
  if (keys.Value("size_m").is_array()) return keys.Vector3("size_m", kSize);
  return Eigen::Vector3d::Constant(keys.Number("size_m", kSize));
}

// Mean distance of a body from the camera. The size of a body with `size_px` is chosen so that its
// largest side has that many pixels at this distance, which suits a body that hardly moves.
double MeanDistance_m(const Placement& placed, const Motion& motion) {
  double sum = 0.0;
  const auto& camera = placed.camera().world_from_body;
  for (std::size_t i = 0; i < camera.size(); ++i) {
    const double time_s =
        placed.duration_s() * static_cast<double>(i) / static_cast<double>(camera.size() - 1);
    sum += (motion.At(time_s).world_from_body.translation() - camera[i].translation()).norm();
  }
  return sum / static_cast<double>(camera.size());
}

CollisionShape ShapeOf(const std::string& model, const Eigen::Vector3d& size_m) {
  CollisionShape shape;
  shape.half_size_m = 0.5 * size_m;
  if (model == "ball") shape.radius_m = 0.5 * size_m.x();
  return shape;
}

// Returns null if the drawn points give no smooth curve.
std::shared_ptr<const Motion> MotionOf(const Json& path, const CollisionShape& shape,
                                       double duration_s, const std::string& where) {
  const BodyShape body = {shape.half_size_m.z(), shape.radius_m};
  const PathDescription described = ParsePath(ObjectReader(path, where, "path"));
  try {
    return MakeMotion(described, body, duration_s);
  } catch (const Error&) {
    return nullptr;
  }
}

class Generator {
 public:
  Generator(const Family& family, std::uint32_t seed, const std::vector<std::string>& set)
      : family_(family), seed_(seed), draws_(family.name, seed, family.knobs, set) {
    for (const std::string& assignment : set) set_text_ += ", " + assignment;
  }

  Json Generate() {
    TakeScene();
    const std::vector<Group> groups = TakeGroups();
    for (int attempt = 0; attempt < kLayoutTries; ++attempt) {
      if (std::optional<Json> scene = TryLayout(groups, attempt)) return *scene;
    }
    ThrowError(StrCat(family_.where, ", seed ", seed_),
               StrCat(failure_, " in ", kLayoutTries, " layouts of ", kBodyTries, " tries each"),
               "fewer, smaller or slower bodies, or more space");
  }

 private:
  void TakeScene() {
    constexpr std::uint64_t kLookSeeds = 1000000000;
    scene_ = {{"name", StrCat(family_.name, "_", seed_)},
              {"about", StrCat("Family ", family_.name, ", seed ", seed_, " (",
                               SplitName(SplitOf(seed_)), " split)", set_text_)},
              {"seed", seed_},
              {"look_seed", draws_.Stream("look").UniformInt(kLookSeeds)}};
    const Json taken = draws_.Take(family_.scene, "scene");
    ObjectReader reader(taken, family_.where, "scene");
    duration_s_ = reader.Number("duration_s", {0.1, 3600.0});
    const double rate_hz = reader.Number("rate_hz", {0.1, 1000.0});
    for (const auto& [key, value] : taken.items()) {
      if (key != "duration_s") scene_[key] = value;
    }
    const int frames = std::max(2, static_cast<int>(std::lround(duration_s_ * rate_hz)));
    scene_["frames"] = frames;
    duration_s_ = frames / rate_hz;
    focal_px_ = reader.Object("rig").Number("focal_px", {1.0, 1e5});
  }

  std::vector<Group> TakeGroups() {
    std::vector<Group> groups;
    ObjectReader layout(family_.layout, family_.where, "layout");
    layout.Value("bodies");  // throws if it is missing
    for (ObjectReader& keys : layout.ObjectsOr("bodies")) {
      Group group;
      group.where = keys.Where("");
      const Json taken =
          draws_.Take({{"count", keys.Value("count")}}, StrCat("group ", groups.size()));
      group.count = ObjectReader(taken, group.where, "").Integer("count", {0, 1000});
      group.in_view = keys.Number("in_view", {0.0, 1.0});
      keys.Object("body");  // throws if it is not an object
      group.body = keys.Value("body");
      keys.Finish();
      groups.push_back(std::move(group));
    }
    return groups;
  }

  std::unique_ptr<Layout> MakeLayout(const std::string& stream) {
    Json whole = family_.layout;
    whole.erase("bodies");
    const Json taken = draws_.Take(whole, stream);
    ObjectReader keys(taken, family_.where, "layout");
    const std::string kind = keys.Text("kind");
    std::unique_ptr<Layout> layout;
    if (kind == "room") {
      layout = MakeRoomLayout(scene_, duration_s_, keys, draws_.Stream(stream));
    } else if (kind == "street") {
      layout = MakeStreetLayout(duration_s_, keys, draws_.Stream(stream));
    } else {
      ThrowError(keys.Where("kind"), Quoted(kind), "\"room\" or \"street\"");
    }
    keys.Finish();
    return layout;
  }

  // Returns nothing if a layout or a body does not fit; `failure_` says which.
  std::optional<Json> TryLayout(const std::vector<Group>& groups, int attempt) {
    const std::string stream = StrCat("layout ", attempt);
    const std::unique_ptr<Layout> layout = MakeLayout(stream);
    Json scene = scene_;
    if (const Json street = layout->Street(); !street.is_null()) scene["street"] = street;
    scene["camera"] = layout->Camera();
    scene["objects"] = Json::array();
    const SceneDescription described = SceneDescription::Parse(scene, family_.where);
    const SceneParts& parts = described.parts();
    std::shared_ptr<const Motion> camera;
    try {
      camera = MakeCameraMotion(parts.camera, duration_s_, parts.look_seed);
    } catch (const Error& error) {
      failure_ = error.what();
      return std::nullopt;
    }
    Placement placed(parts.rig, *camera, duration_s_, layout->Limits());
    count_of_.clear();
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (int i = 0; i < groups[g].count; ++i) {
        const std::string body = StrCat(stream, "/group ", g, "/body ", i);
        if (PlaceBody(groups[g], body, *layout, placed, scene["objects"])) continue;
        failure_ =
            StrCat("no place for body ", i + 1, " of ", groups[g].count, " of ", groups[g].where);
        return std::nullopt;
      }
    }
    return scene;
  }

  bool PlaceBody(const Group& group, const std::string& stream, const Layout& layout,
                 Placement& placed, Json& objects) {
    for (int attempt = 0; attempt < kBodyTries; ++attempt) {
      std::optional<Json> object = TryBody(group, StrCat(stream, "/", attempt), layout, placed);
      if (!object) continue;
      objects.push_back(std::move(*object));
      return true;
    }
    return false;
  }

  std::optional<Json> TryBody(const Group& group, const std::string& stream, const Layout& layout,
                              Placement& placed) {
    const Json taken = draws_.Take(group.body, stream);
    ObjectReader keys(taken, group.where, "body");
    const std::string model = keys.Text("model");
    Rng rng = draws_.Stream(stream + "/path");
    BodyRequest request = {keys, SizeOf(keys), placed, rng};
    Json object = {{"name", StrCat(model, "_", count_of_[model] + 1)}, {"model", model}};
    for (const char* key : {"material", "category"}) {
      if (keys.Has(key)) object[key] = keys.Text(key);
    }
    const bool by_pixels = keys.Has("size_px") && !keys.Value("size_px").is_null();
    const double size_px = by_pixels ? keys.Number("size_px", {1.0, 4000.0}) : 0.0;
    const std::optional<Json> path = layout.MakePath(keys.Text("motion"), request);
    if (!path) return std::nullopt;
    keys.Finish();
    if (by_pixels) {
      const auto motion = MotionOf(*path, ShapeOf(model, request.size_m), duration_s_, group.where);
      if (!motion) return std::nullopt;
      const double side_m = size_px * MeanDistance_m(placed, *motion) / focal_px_;
      request.size_m *= side_m / request.size_m.maxCoeff();
    }
    for (double& side : request.size_m) side = Millis(side);
    const CollisionShape shape = ShapeOf(model, request.size_m);
    const auto motion = MotionOf(*path, shape, duration_s_, group.where);
    if (!motion || !placed.TryAdd(shape, *motion, group.in_view)) return std::nullopt;
    const Eigen::Vector3d& size = request.size_m;
    object["size_m"] = model == "ball" ? Json(size.x()) : Json({size.x(), size.y(), size.z()});
    object["path"] = *path;
    ++count_of_[model];
    return object;
  }

  const Family& family_;
  std::uint32_t seed_;
  std::string set_text_;
  Draws draws_;
  Json scene_;
  double duration_s_ = 0.0;
  double focal_px_ = 0.0;
  std::map<std::string, int> count_of_;  // bodies per model, for names
  std::string failure_;
};

}  // namespace

Json GenerateScene(const Family& family, std::uint32_t seed, const std::vector<std::string>& set) {
  return Generator(family, seed, set).Generate();
}

}  // namespace cvo::synth
