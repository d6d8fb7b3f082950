// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "synth/scene/parse_scene.h"

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

}  // namespace cvo::synth
