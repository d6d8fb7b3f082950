// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/error.h"
#include "synth/scene/description.h"

namespace cvo::synth {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr Range kLength = {0.0, 1e5};
constexpr Range kAngle = {-3600.0, 3600.0};
constexpr Range kSpeed = {0.0, 50.0};
constexpr Range kPeriod = {0.05, 1e4};

Oscillation ParseOscillation(ObjectReader reader) {
  Oscillation oscillation;
  oscillation.amplitude_rad = kRadPerDeg * reader.Number("amplitude_deg", {0.0, 180.0});
  oscillation.period_s = reader.Number("period_s", kPeriod);
  oscillation.phase_rad = kRadPerDeg * reader.NumberOr("phase_deg", kAngle, 0.0);
  reader.Finish();
  return oscillation;
}

std::vector<SpeedProfile::Knot> ParseSpeed(ObjectReader& route) {
  if (!route.Value("speed_mps").is_array()) return {{0.0, route.Number("speed_mps", kSpeed)}};
  std::vector<SpeedProfile::Knot> knots;
  for (const std::vector<double>& row : route.Rows("speed_mps", kPlace, 2, 1)) {
    const std::string where = StrCat(route.Where("speed_mps"), ".", knots.size());
    if (!(row[1] >= kSpeed.min && row[1] <= kSpeed.max)) {
      ThrowError(where + ".1", StrCat(row[1]),
                 StrCat("a value in [", kSpeed.min, ", ", kSpeed.max, "]"));
    }
    if (!knots.empty() && !(row[0] > knots.back().time_s)) {
      ThrowError(where + ".0", StrCat(row[0]), StrCat("a time after ", knots.back().time_s));
    }
    knots.push_back({row[0], row[1]});
  }
  return knots;
}

HeadingDescription ParseHeading(ObjectReader& route) {
  HeadingDescription heading;
  if (!route.Has("heading")) return heading;
  if (route.Value("heading").is_string()) {
    const std::string text = route.Text("heading");
    if (text == "along") return heading;
    ThrowError(route.Where("heading"), text, "\"along\" or an object");
  }
  ObjectReader reader = route.Object("heading");
  heading.along = !reader.Has("fixed_deg");
  if (!heading.along) heading.offset_rad = kRadPerDeg * reader.Number("fixed_deg", kAngle);
  if (heading.along) heading.offset_rad = kRadPerDeg * reader.NumberOr("offset_deg", kAngle, 0.0);
  heading.spin_radps = kRadPerDeg * reader.NumberOr("spin_degps", kAngle, 0.0);
  reader.Finish();
  return heading;
}

RouteDescription ParseRouteKeys(ObjectReader& reader) {
  RouteDescription route;
  route.where = reader.Where("");
  for (const std::vector<double>& row : reader.Rows("points", kPlace, 2, 2)) {
    route.points.emplace_back(row[0], row[1]);
  }
  route.closed = reader.BoolOr("closed", false);
  if (reader.Has("corner_m")) route.corner_m = reader.Number("corner_m", {0.01, 1e4});
  route.speed = ParseSpeed(reader);
  route.start_m = reader.NumberOr("start_m", kLength, 0.0);
  route.lateral_m = reader.NumberOr("lateral_m", kPlace, 0.0);
  return route;
}

StillDescription ParseStill(ObjectReader reader) {
  StillDescription still;
  const std::vector<double> at = reader.Numbers("at", kPlace, {2, 3});
  still.at = {at[0], at[1]};
  if (at.size() == 3) still.centre_m = at[2];
  still.heading_rad = kRadPerDeg * reader.NumberOr("heading_deg", kAngle, 0.0);
  reader.Finish();
  return still;
}

SwingDescription ParseSwing(ObjectReader reader) {
  SwingDescription swing;
  swing.pivot = reader.Vector3("pivot", kPlace);
  swing.length_m = reader.Number("length_m", {0.01, 100.0});
  swing.swing.amplitude_rad = kRadPerDeg * reader.Number("amplitude_deg", {0.0, 80.0});
  swing.swing.period_s = reader.Number("period_s", kPeriod);
  swing.swing.phase_rad = kRadPerDeg * reader.NumberOr("phase_deg", kAngle, 0.0);
  swing.plane_rad = kRadPerDeg * reader.NumberOr("plane_deg", kAngle, 0.0);
  swing.heading_rad = kRadPerDeg * reader.NumberOr("heading_deg", kAngle, 0.0);
  if (reader.Has("twist")) swing.twist = ParseOscillation(reader.Object("twist"));
  reader.Finish();
  return swing;
}

LookAt ParseLookAt(ObjectReader reader) {
  LookAt look;
  look.where = reader.Where("");
  for (const std::vector<double>& row : reader.Rows("points", kPlace, 3, 1)) {
    look.points.emplace_back(row[0], row[1], row[2]);
  }
  reader.Finish();
  return look;
}

LookAlong ParseLookAlong(ObjectReader reader) {
  LookAlong look;
  look.yaw_rad = kRadPerDeg * reader.NumberOr("yaw_deg", kAngle, 0.0);
  look.pitch_rad = kRadPerDeg * reader.NumberOr("pitch_deg", {-80.0, 80.0}, 0.0);
  if (reader.Has("pan")) look.pan = ParseOscillation(reader.Object("pan"));
  reader.Finish();
  return look;
}

constexpr Range kUnit = {0.0, 1.0};
constexpr double kMaxCount = 1000;

// Names are restricted because they become file names and parts of other names.
std::string ParseName(ObjectReader& reader) {
  const std::string name = reader.Text("name");
  const bool good = !name.empty() && name.size() <= 64 &&
                    std::all_of(name.begin(), name.end(), [](unsigned char c) {
                      return (c < 128 && std::isalnum(c) != 0) || c == '_' || c == '-';
                    });
  if (!good) {
    ThrowError(reader.Where("name"), '"' + name + '"', "1 to 64 letters, digits, _ and -");
  }
  return name;
}

RigError ParseRigError(ObjectReader reader) {
  RigError error;
  error.shift_px = reader.NumberOr("shift_px", {-100.0, 100.0}, error.shift_px);
  if (reader.Has("rotation_deg")) {
    const Eigen::Vector3d deg = reader.Vector3("rotation_deg", {-5.0, 5.0});
    error.rotation_deg = {deg.x(), deg.y(), deg.z()};
  }
  error.focal = reader.NumberOr("focal", {-0.1, 0.1}, error.focal);
  reader.Finish();
  return error;
}

void ParseRig(ObjectReader reader, SceneParts& scene) {
  StereoCamera& rig = scene.rig;
  rig.width_px = reader.Integer("width_px", {16, 8192});
  rig.height_px = reader.Integer("height_px", {16, 8192});
  rig.fx = rig.fy = reader.Number("focal_px", {1.0, 1e5});
  rig.cx = reader.NumberOr("cx_px", kPlace, 0.5 * (rig.width_px - 1));
  rig.cy = reader.NumberOr("cy_px", kPlace, 0.5 * (rig.height_px - 1));
  rig.baseline_m = reader.Number("baseline_m", {1e-3, 10.0});
  if (reader.Has("error")) scene.rig_error = ParseRigError(reader.Object("error"));
  reader.Finish();
}

RoomDescription ParseRoom(ObjectReader reader) {
  RoomDescription room;
  room.size_m = reader.Vector3Or("size_m", {1.0, 200.0}, room.size_m);
  room.shelves = reader.IntegerOr("shelves", {0, kMaxCount}, room.shelves);
  room.tables = reader.IntegerOr("tables", {0, kMaxCount}, room.tables);
  room.crates = reader.IntegerOr("crates", {0, kMaxCount}, room.crates);
  room.posters = reader.IntegerOr("posters", {0, kMaxCount}, room.posters);
  room.furniture_depth_m = reader.NumberOr("furniture_depth_m", {0.3, 5.0}, room.furniture_depth_m);
  reader.Finish();
  return room;
}

StreetDescription ParseStreet(ObjectReader reader) {
  StreetDescription street;
  reader.Value("roads");
  for (ObjectReader& road : reader.ObjectsOr("roads")) {
    RoadDescription parsed;
    for (const std::vector<double>& row : road.Rows("points", kPlace, 2, 2)) {
      parsed.points.emplace_back(row[0], row[1]);
    }
    parsed.width_m = road.NumberOr("width_m", {2.0, 100.0}, parsed.width_m);
    parsed.corner_radius_m = road.NumberOr("corner_radius_m", {0.5, 1e3}, parsed.corner_radius_m);
    road.Finish();
    street.roads.push_back(parsed);
  }
  street.pavement_m = reader.NumberOr("pavement_m", {0.5, 50.0}, street.pavement_m);
  street.building_height_m =
      reader.NumberOr("building_height_m", {3.5, 200.0}, street.building_height_m);
  street.trees_per_100m = reader.NumberOr("trees_per_100m", {0.0, 50.0}, street.trees_per_100m);
  reader.Finish();
  return street;
}

Light ParseLight(ObjectReader reader) {
  Light light;
  light.direction = reader.Vector3Or("direction", {-1e3, 1e3}, light.direction);
  if (light.direction.norm() < 1e-6) {
    ThrowError(reader.Where("direction"), "a vector of length zero", "a direction");
  }
  const double brightness = reader.NumberOr("brightness", {0.0, 10.0}, 1.0);
  light.directional = brightness * reader.NumberOr("directional", {0.0, 10.0}, light.directional);
  light.ambient = brightness * reader.NumberOr("ambient", {0.0, 10.0}, light.ambient);
  light.sky_rgb = reader.Vector3Or("sky_rgb", kUnit, light.sky_rgb);
  light.shadow_range_m = reader.NumberOr("shadow_range_m", {0.5, 1e3}, light.shadow_range_m);
  reader.Finish();
  return light;
}

std::string DefaultCategory(std::string kind) {
  if (!kind.empty()) kind[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(kind[0])));
  return kind;
}

ModelDescription ParseModel(ObjectReader& reader) {
  constexpr Range kSize = {0.01, 200.0};
  ModelDescription model;
  model.kind = reader.Text("model");
  if (reader.Has("size_m")) {
    model.size_m = reader.Value("size_m").is_array()
                       ? reader.Vector3("size_m", kSize)
                       : Eigen::Vector3d::Constant(reader.Number("size_m", kSize)).eval();
  }
  model.material = reader.TextOr("material", "");
  return model;
}

struct Copies {
  int count = 1;
  double spacing_m = 0.0;
  std::optional<double> direction_rad;
};

Copies ParseCopies(ObjectReader reader) {
  Copies copies;
  copies.count = reader.Integer("count", {1, 1000});
  copies.spacing_m = reader.Number("spacing_m", {0.01, 1e4});
  if (reader.Has("direction_deg")) {
    copies.direction_rad =
        reader.Number("direction_deg", {-3600.0, 3600.0}) * std::numbers::pi / 180.0;
  }
  reader.Finish();
  return copies;
}

// Moves the path of a copy by `way_m`: along a route, otherwise in a straight line.
struct MovedPath {
  double way_m;
  std::optional<double> direction_rad;

  Eigen::Vector2d Step(double default_rad) const {
    const double direction = direction_rad.value_or(default_rad);
    return way_m * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  }
  PathDescription operator()(StillDescription still) const {
    still.at += Step(still.heading_rad);
    return still;
  }
  PathDescription operator()(RouteDescription route) const {
    route.start_m += way_m;
    return route;
  }
  PathDescription operator()(SwingDescription swing) const {
    swing.pivot.head<2>() += Step(swing.plane_rad + 0.5 * std::numbers::pi);
    return swing;
  }
};

void ParseObject(ObjectReader& reader, SceneParts& scene) {
  ObjectDescription object;
  object.where = reader.Where("");
  object.name = ParseName(reader);
  object.model = ParseModel(reader);
  object.category = reader.TextOr("category", DefaultCategory(object.model.kind));
  const bool plain = std::none_of(object.category.begin(), object.category.end(),
                                  [](unsigned char c) { return std::isspace(c) != 0; });
  if (object.category.empty() || !plain) {
    ThrowError(reader.Where("category"), '"' + object.category + '"', "one word");
  }
  object.path = ParsePath(reader.Object("path"));
  const bool repeated = reader.Has("copies");
  const Copies copies = repeated ? ParseCopies(reader.Object("copies")) : Copies{};
  reader.Finish();
  for (int i = 0; i < copies.count; ++i) {
    ObjectDescription copy = object;
    if (repeated) copy.name += StrCat("_", i + 1);
    copy.path = std::visit(MovedPath{i * copies.spacing_m, copies.direction_rad}, object.path);
    scene.objects.push_back(copy);
  }
}

void CheckObjects(const SceneParts& scene, const std::string& where) {
  constexpr std::size_t kMaxBodies = 1000;  // which take seconds per frame
  if (scene.objects.size() > kMaxBodies) {
    ThrowError(where + ", objects", StrCat(scene.objects.size(), " bodies"),
               StrCat("at most ", kMaxBodies));
  }
  std::set<std::string> names;
  for (const ObjectDescription& object : scene.objects) {
    if (!names.insert(object.name).second) {
      ThrowError(object.where + ".name", object.name + " for the second time",
                 "another name for each body");
    }
  }
}

}  // namespace

RouteDescription ParseRoute(ObjectReader reader) {
  const RouteDescription route = ParseRouteKeys(reader);
  reader.Finish();
  return route;
}

PathDescription ParsePath(ObjectReader path) {
  const std::string kind = path.OneOf({"still", "route", "swing"});
  path.Finish();
  ObjectReader reader = path.Object(kind);
  if (kind == "still") return ParseStill(reader);
  if (kind == "swing") return ParseSwing(reader);
  RouteDescription route = ParseRouteKeys(reader);
  route.bottom_m = reader.NumberOr("bottom_m", kLength, 0.0);
  route.heading = ParseHeading(reader);
  reader.Finish();
  return route;
}

CameraDescription ParseCamera(ObjectReader reader) {
  CameraDescription camera;
  camera.route = ParseRoute(reader.Object("route"));
  camera.height_m = reader.Number("height_m", {0.05, 100.0});
  if (reader.OneOf({"look_at", "look_along"}) == "look_at") {
    camera.look = ParseLookAt(reader.Object("look_at"));
  } else {
    camera.look = ParseLookAlong(reader.Object("look_along"));
  }
  if (reader.Has("shake")) {
    ObjectReader shake = reader.Object("shake");
    camera.shake.translation_m = shake.NumberOr("translation_m", {0.0, 0.2}, 0.0);
    camera.shake.rotation_rad = kRadPerDeg * shake.NumberOr("rotation_deg", {0.0, 20.0}, 0.0);
    camera.shake.frequency_hz = shake.NumberOr("frequency_hz", {0.01, 20.0}, 1.5);
    shake.Finish();
  }
  reader.Finish();
  return camera;
}

SceneParts ParseScene(const Json& json, const std::string& where) {
  ObjectReader reader(json, where, "");
  SceneParts scene;
  scene.name = ParseName(reader);
  scene.about = reader.TextOr("about", "");
  scene.seed = reader.SeedOr("seed", 0);
  scene.look_seed = reader.SeedOr("look_seed", 0);
  ParseRig(reader.Object("rig"), scene);
  scene.frames = reader.Integer("frames", {1, 1e6});
  scene.rate_hz = reader.Number("rate_hz", {0.1, 1000.0});
  if (reader.OneOf({"room", "street"}) == "room") {
    scene.surroundings = ParseRoom(reader.Object("room"));
  } else {
    scene.surroundings = ParseStreet(reader.Object("street"));
  }
  if (reader.Has("light")) scene.light = ParseLight(reader.Object("light"));
  scene.texture_contrast = reader.NumberOr("texture_contrast", {0.0, 2.0}, scene.texture_contrast);
  scene.camera = ParseCamera(reader.Object("camera"));
  for (ObjectReader& object : reader.ObjectsOr("objects")) ParseObject(object, scene);
  for (const char* key : {"sensor", "detector"}) {
    if (!reader.Has(key)) continue;
    reader.Object(key);  // must be an object; synth/write checks its content
    (std::string(key) == "sensor" ? scene.sensor : scene.detector) = reader.Value(key);
  }
  reader.Finish();
  CheckObjects(scene, where);
  return scene;
}

}  // namespace cvo::synth
