// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/error.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "synth/family/family.h"
#include "synth/models/model.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kCameraMargin_m = 0.25;  // to furniture
constexpr double kBodyMargin_m = 0.05;

struct Area {
  Vector2d low;
  Vector2d high;

  Vector2d Middle() const { return 0.5 * (low + high); }
  Vector2d Half() const { return 0.5 * (high - low); }
  Vector2d Point(Rng& rng) const {
    const double x = rng.Uniform(low.x(), high.x());
    return {x, rng.Uniform(low.y(), high.y())};
  }
};

// A closed curve around an ellipse, with radii reduced by up to the fraction `roughness`.
struct Ring {
  Vector2d middle;
  Vector2d half;
  double roughness = 0.0;
};

Json RingPoints(const Ring& ring, int count, Rng& rng) {
  const double phase = rng.Uniform(0.0, 2.0 * std::numbers::pi);
  const double turn = rng.UniformInt(2) == 0 ? 1.0 : -1.0;
  Json points = Json::array();
  for (int i = 0; i < count; ++i) {
    const double angle = phase + turn * 2.0 * std::numbers::pi * i / count;
    const double part = 1.0 - ring.roughness * rng.Uniform();
    points.push_back(PointJson(
        ring.middle + part * ring.half.cwiseProduct(Vector2d(std::cos(angle), std::sin(angle)))));
  }
  return points;
}

class RoomLayout final : public Layout {
 public:
  RoomLayout(const Json& scene, double duration_s, ObjectReader& keys, Rng rng)
      : duration_s_(duration_s) {
    ObjectReader room = ObjectReader(scene, "scene", "").Object("room");
    const Vector3d size_m = room.Vector3("size_m", {2.0, 200.0});
    const double furniture_m =
        room.NumberOr("furniture_depth_m", {0.1, 5.0}, RoomDescription().furniture_depth_m);
    const Vector2d half = 0.5 * size_m.head<2>() - Vector2d::Constant(furniture_m);
    free_ = {-half, half};
    stage_ = free_;
    height_m_ = size_m.z();
    camera_clearance_m_ = keys.NumberOr("camera_clearance_m", {0.05, 10.0}, 0.6);
    PlaceCamera(keys.Object("camera"), rng);
  }

  Json Camera() const override { return camera_; }

  PlacementLimits Limits() const override {
    const auto plane = [](double x, double y, double z, double d) {
      return Eigen::Vector4d(x, y, z, d);
    };
    return {0.1,
            camera_clearance_m_,
            1e3,
            {plane(1, 0, 0, -free_.low.x() - kBodyMargin_m),
             plane(-1, 0, 0, free_.high.x() - kBodyMargin_m),
             plane(0, 1, 0, -free_.low.y() - kBodyMargin_m),
             plane(0, -1, 0, free_.high.y() - kBodyMargin_m), plane(0, 0, 1, 0),
             plane(0, 0, -1, height_m_ - kBodyMargin_m)}};
  }

  std::optional<Json> MakePath(const std::string& motion, BodyRequest& body) const override {
    using Maker = std::optional<Json> (RoomLayout::*)(BodyRequest&) const;
    static const std::map<std::string, Maker> makers = {
        {"cross", &RoomLayout::Cross},   {"loop", &RoomLayout::Loop},
        {"screen", &RoomLayout::Screen}, {"slide", &RoomLayout::Slide},
        {"still", &RoomLayout::Still},   {"swing", &RoomLayout::Swing},
        {"turn", &RoomLayout::Turn}};
    const auto maker = makers.find(motion);
    if (maker != makers.end()) return (this->*maker->second)(body);
    ThrowError(body.keys.Where("motion"), Quoted(motion),
               "cross, loop, screen, slide, still, swing or turn");
  }

 private:
  // "beside": back and forth in a strip along one wall, with the bodies on the other side;
  // "around": around the bodies.
  void PlaceCamera(ObjectReader keys, Rng& rng) {
    const double along = keys.Number("along", {0.1, 1.0});
    const double across_m = keys.Number("across_m", {0.05, 10.0});
    const double gap_m = keys.Number("gap_m", {0.1, 20.0});
    const Vector2d reach = free_.Half() - Vector2d::Constant(kCameraMargin_m);
    Ring ring;
    const std::string path = keys.Text("path");
    if (path == "around") {
      ring = {Vector2d::Zero(), reach, 0.1};
      stage_ = {free_.low + Vector2d::Constant(gap_m), free_.high - Vector2d::Constant(gap_m)};
    } else if (path == "beside") {
      const double x = rng.Uniform(-1.0, 1.0) * (1.0 - along) * reach.x();
      ring = {{x, -reach.y() + across_m}, {along * reach.x(), across_m}, 0.2};
      stage_.low.y() = -reach.y() + 2.0 * across_m + gap_m;
    } else {
      ThrowError(keys.Where("path"), Quoted(path), "\"beside\" or \"around\"");
    }
    if (stage_.Half().minCoeff() < 0.4) {
      ThrowError(keys.Where(""), "no place left for bodies", "a larger room or a smaller gap_m");
    }
    Json route = {{"points", RingPoints(ring, 7, rng)},
                  {"speed_mps", Millis(keys.Number("speed_mps", {0.0, 10.0}))},
                  {"closed", true}};
    camera_["route"] = route;
    camera_["height_m"] = Millis(keys.Number("height_m", {0.1, 10.0}));
    camera_["look_at"] = LookAt(keys, rng);
    if (keys.Has("shake")) camera_["shake"] = keys.Value("shake");
    keys.Finish();
  }

  Json LookAt(ObjectReader& keys, Rng& rng) const {
    const double spread = keys.Number("gaze_spread", {0.05, 1.0});  // fraction of the stage
    const double height_m = keys.Number("gaze_height_m", {0.0, 10.0});
    Json points = Json::array();
    const double turn = rng.UniformInt(2) == 0 ? 1.0 : -1.0;
    for (int i = -1; i <= 1; ++i) {
      // From one side to the other, because a curve that turns back has a cusp.
      const Vector2d offset(turn * i + rng.Uniform(-0.3, 0.3), rng.Uniform(-0.5, 0.5));
      const Vector2d at = stage_.Middle() + spread * stage_.Half().cwiseProduct(offset);
      points.push_back({Millis(at.x()), Millis(at.y()),
                        Millis(std::max(0.05, height_m + rng.Uniform(-0.08, 0.08)))});
    }
    return {{"points", points}};
  }

  std::optional<Json> Still(BodyRequest& body) const {
    return Json{{"still",
                 {{"at", PointJson(stage_.Point(body.rng))},
                  {"heading_deg", static_cast<int>(body.rng.UniformInt(360))}}}};
  }

  std::optional<Json> Turn(BodyRequest& body) const {
    const Vector2d at = stage_.Point(body.rng);
    const Json heading = {{"fixed_deg", static_cast<int>(body.rng.UniformInt(360))},
                          {"spin_degps", body.keys.Number("spin_degps", {-360.0, 360.0})}};
    return Json{{"route",
                 {{"points", {PointJson(at), PointJson(at + Vector2d(0.1, 0.0))}},
                  {"speed_mps", 0},
                  {"heading", heading}}}};
  }

  // A route with the speed that the body's keys give.
  Json Travel(BodyRequest& body, const Json& points, double length_m) const {
    const SpeedRequest speed = {body.keys.Number("speed_mps", {0.01, 10.0}),
                                body.keys.IntegerOr("stops", {0, 5}, 0), duration_s_, length_m};
    return {{"points", points}, {"speed_mps", SpeedKnots(speed, body.rng)}};
  }

  static void AddSpin(BodyRequest& body, Json& route) {
    if (!body.keys.Has("spin_degps")) return;
    route["heading"] = {{"spin_degps", body.keys.Number("spin_degps", {-360.0, 360.0})}};
  }

  // Moves from one place to another on a bent path.
  std::optional<Json> Cross(BodyRequest& body) const {
    constexpr double kLeastWay_m = 0.6;
    const Vector2d from = stage_.Point(body.rng);
    const Vector2d to = stage_.Point(body.rng);
    const Vector2d way = to - from;
    const Vector2d middle = from + body.rng.Uniform(0.4, 0.6) * way +
                            body.rng.Uniform(-0.25, 0.25) * Vector2d(-way.y(), way.x());
    if (way.norm() < kLeastWay_m) return std::nullopt;
    Json route = Travel(body, {PointJson(from), PointJson(middle), PointJson(to)},
                        0.98 * ((middle - from).norm() + (to - middle).norm()));
    AddSpin(body, route);
    return Json{{"route", route}};
  }

  // Moves straight, without turning.
  std::optional<Json> Slide(BodyRequest& body) const {
    constexpr double kLeastWay_m = 0.6;
    const Vector2d from = stage_.Point(body.rng);
    const Vector2d to = stage_.Point(body.rng);
    const double length_m = (to - from).norm();
    if (length_m < kLeastWay_m) return std::nullopt;
    Json route = Travel(body, {PointJson(from), PointJson(to)}, 0.98 * length_m);
    route["heading"] = {{"fixed_deg", static_cast<int>(body.rng.UniformInt(360))}};
    return Json{{"route", route}};
  }

  std::optional<Json> Loop(BodyRequest& body) const {
    constexpr double kEndless_m = 1e6;
    Ring ring{stage_.Point(body.rng), {}, 0.25};
    ring.half = {body.rng.Uniform(0.3, 0.9) * stage_.Half().x(),
                 body.rng.Uniform(0.3, 0.9) * stage_.Half().y()};
    Json route = Travel(body, RingPoints(ring, 7, body.rng), kEndless_m);
    route["closed"] = true;
    AddSpin(body, route);
    return Json{{"route", route}};
  }

  // Hangs from the ceiling with its centre at height `middle_m`.
  std::optional<Json> Swing(BodyRequest& body) const {
    const Vector2d at = stage_.Point(body.rng);
    const double pivot_m = height_m_ - 0.1;
    const double middle_m = body.keys.Number("middle_m", {0.1, 10.0});
    if (middle_m > pivot_m - 0.3) return std::nullopt;
    Json swing = {{"pivot", {Millis(at.x()), Millis(at.y()), Millis(pivot_m)}},
                  {"length_m", Millis(pivot_m - middle_m)},
                  {"amplitude_deg", body.keys.Number("amplitude_deg", {0.0, 80.0})},
                  {"period_s", Millis(body.keys.Number("period_s", {0.2, 100.0}))},
                  {"phase_deg", static_cast<int>(body.rng.UniformInt(360))},
                  {"plane_deg", static_cast<int>(body.rng.UniformInt(180))}};
    if (body.keys.Has("twist_deg")) {
      swing["twist"] = {{"amplitude_deg", body.keys.Number("twist_deg", {0.0, 180.0})},
                        {"period_s", Millis(body.rng.Uniform(2.0, 4.0))}};
    }
    return Json{{"swing", swing}};
  }

  // Stands between the camera and a moving body, wide enough to hide it for `hidden_s`.
  std::optional<Json> Screen(BodyRequest& body) const {
    constexpr double kLeastMoved_m = 0.3;
    constexpr double kThickness_m = 0.16;
    constexpr double kNarrowest_m = 0.2;
    constexpr double kWidest_m = 1.8;
    const double hidden_s = body.keys.Number("hidden_s", {0.05, 60.0});
    std::vector<const Track*> movers;
    for (const Track& track : body.placed.bodies()) {
      if (track.Moved_m() > kLeastMoved_m) movers.push_back(&track);
    }
    if (movers.empty()) return std::nullopt;
    const Track& mover = *movers[body.rng.UniformInt(movers.size())];
    const std::size_t last = mover.world_from_body.size() - 2;
    const auto i =
        static_cast<std::size_t>(body.rng.Uniform(0.25, 0.75) * static_cast<double>(last));
    const double step_s = duration_s_ / static_cast<double>(last + 1);
    const double part = body.rng.Uniform(0.45, 0.7);  // of the distance from the camera to the body
    const auto sight = [&](std::size_t k) -> Vector3d {
      const Vector3d eye = body.placed.camera().world_from_body[k].translation();
      return eye + part * (mover.world_from_body[k].translation() - eye);
    };
    const Vector3d eye = body.placed.camera().world_from_body[i].translation();
    const Vector3d target = mover.world_from_body[i].translation();
    const Vector2d towards = (target - eye).head<2>().normalized();
    const Vector2d rate = (sight(i + 1) - sight(i)).head<2>() / step_s;
    const double across_mps = std::abs(rate.x() * towards.y() - rate.y() * towards.x());
    const double body_m = 2.0 * mover.shape.half_size_m.head<2>().norm();
    const double width_m = across_mps * hidden_s + part * body_m;
    const double top_m = target.z() + mover.shape.half_size_m.z();
    const double height_m = eye.z() + part * (top_m - eye.z()) + 0.05;
    if (width_m < kNarrowest_m || width_m > kWidest_m || height_m < 0.3) return std::nullopt;
    body.size_m = {kThickness_m, Millis(width_m), Millis(height_m)};
    const double heading_deg = std::atan2(towards.y(), towards.x()) * 180.0 / std::numbers::pi;
    return Json{
        {"still",
         {{"at", PointJson(sight(i).head<2>())}, {"heading_deg", std::round(heading_deg)}}}};
  }

  double duration_s_;
  double camera_clearance_m_;
  Area free_;   // free of furniture
  Area stage_;  // where bodies are placed
  double height_m_ = 0.0;
  Json camera_;
};

}  // namespace

std::unique_ptr<Layout> MakeRoomLayout(const Json& scene, double duration_s, ObjectReader& keys,
                                       Rng rng) {
  return std::make_unique<RoomLayout>(scene, duration_s, keys, rng);
}

}  // namespace cvo::synth
