// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "synth/family/family.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;

constexpr double kMainWidth_m = 13.6;  // two lanes and two rows of parked cars
constexpr double kSideWidth_m = 9.0;
constexpr double kLane_m = 2.7;
constexpr double kSideLane_m = 2.25;
constexpr double kParked_m = 5.65;
constexpr Range kBodySpeed_mps = {0.1, 60.0};
constexpr double kCorner_m = 16.1;
constexpr double kMainStart_m = -80.0;
constexpr double kEgoStart_m = 40.0;  // along the main road
constexpr double kSideHalf_m = 90.0;

Json KnotsJson(const std::vector<std::pair<double, double>>& knots, double earlier_s) {
  Json rows = Json::array();
  for (const auto& [time_s, speed] : knots) {
    rows.push_back({Millis(time_s - earlier_s), Millis(speed)});
  }
  return rows;
}

// A main road along x, roads across it, and the path of the car that carries the camera.
class StreetLayout final : public Layout {
 public:
  StreetLayout(double duration_s, ObjectReader& keys, Rng rng) : duration_s_(duration_s) {
    ObjectReader camera = keys.Object("camera");
    ego_mps_ = camera.Number("speed_mps", {0.0, 40.0});
    LayRoads(keys.Object("roads"), rng);
    PlaceCamera(camera, rng);
  }

  Json Camera() const override { return camera_; }
  Json Street() const override { return street_; }
  PlacementLimits Limits() const override { return {0.4, 2.5, 60.0, {}}; }

  std::optional<Json> MakePath(const std::string& motion, BodyRequest& body) const override {
    using Maker = std::optional<Json> (StreetLayout::*)(BodyRequest&) const;
    static const std::map<std::string, Maker> makers = {{"crossing", &StreetLayout::Crossing},
                                                        {"lead", &StreetLayout::Lead},
                                                        {"oncoming", &StreetLayout::Oncoming},
                                                        {"overtaking", &StreetLayout::Overtaking},
                                                        {"parked", &StreetLayout::Parked}};
    const auto maker = makers.find(motion);
    if (maker != makers.end()) return (this->*maker->second)(body);
    ThrowError(body.keys.Where("motion"), Quoted(motion),
               "crossing, lead, oncoming, overtaking or parked");
  }

 private:
  void LayRoads(ObjectReader keys, Rng& rng) {
    constexpr double kBeyond_m = 70.0;
    const std::string turn = keys.Text("turn");
    if (turn != "none" && turn != "left" && turn != "right") {
      ThrowError(keys.Where("turn"), Quoted(turn), "\"none\", \"left\" or \"right\"");
    }
    width_m_ = keys.NumberOr("width_m", {4.0, 60.0}, kMainWidth_m);
    lane_m_ = keys.NumberOr("lane_m", {1.0, 0.5 * width_m_ - 1.0}, kLane_m);
    const int crossings = std::max(keys.Integer("crossings", {0, 20}), turn == "none" ? 0 : 1);
    double x = kMainStart_m + kEgoStart_m;
    for (int i = 0; i < crossings; ++i) {
      x += i == 0 ? rng.Uniform(34.0, 62.0) : rng.Uniform(45.0, 75.0);
      crossings_m_.push_back(Millis(x));
    }
    const double way_m = ego_mps_ * duration_s_;
    turn_ = turn == "none" ? 0 : (turn == "left" ? 1 : -1);
    main_end_m_ = Millis(std::max(x, kMainStart_m + kEgoStart_m + way_m) + kBeyond_m);
    if (turn_ != 0) turn_at_m_ = crossings_m_[0];
    turn_end_m_ = Millis(std::max(kSideHalf_m, way_m + kBeyond_m));
    Json roads =
        Json::array({{{"points", {{kMainStart_m, 0}, {main_end_m_, 0}}}, {"width_m", width_m_}}});
    for (const double at : crossings_m_) {
      const bool turned_into = turn_ != 0 && at == turn_at_m_;
      const double end = turned_into ? turn_end_m_ : kSideHalf_m;
      const double low = turn_ < 0 && turned_into ? -end : -kSideHalf_m;
      const double high = turn_ > 0 && turned_into ? end : kSideHalf_m;
      roads.push_back({{"points", {{at, low}, {at, high}}},
                       {"width_m", turned_into ? width_m_ : kSideWidth_m}});
    }
    street_ = {{"roads", roads},
               {"building_height_m", keys.Number("building_height_m", {1.0, 200.0})},
               {"trees_per_100m", keys.Number("trees_per_100m", {0.0, 100.0})}};
    if (keys.Has("pavement_m")) street_["pavement_m"] = keys.Number("pavement_m", {0.5, 50.0});
    keys.Finish();
  }

  void PlaceCamera(ObjectReader keys, Rng& rng) {
    const double v = ego_mps_;
    if (turn_ == 0) {
      ego_speed_ = {{0.0, v},
                    {0.5 * duration_s_, v * rng.Uniform(0.75, 1.0)},
                    {duration_s_, v * rng.Uniform(0.75, 1.0)}};
    } else {
      // Slower before the bend, faster after it.
      const double slow = std::min(v, rng.Uniform(5.0, 7.5));
      const double brake_s = std::max(0.1, (WayToTurn_m() - 32.0) / std::max(v, 0.1));
      const double bend_s = 44.0 / std::max(slow, 0.1);
      ego_speed_ = {{0.0, v},
                    {brake_s, v},
                    {brake_s + 2.2, slow},
                    {brake_s + 2.2 + bend_s, slow},
                    {brake_s + 6.2 + bend_s, v}};
    }
    Json route = {{"points", EgoPoints()},
                  {"corner_m", kCorner_m},
                  {"start_m", kEgoStart_m},
                  {"lateral_m", -lane_m_},
                  {"speed_mps", KnotsJson(ego_speed_, 0.0)}};
    camera_ = {{"route", route},
               {"height_m", Millis(keys.Number("height_m", {0.3, 5.0}))},
               {"look_along", Json::object()}};
    if (keys.Has("shake")) camera_["shake"] = keys.Value("shake");
    keys.Finish();
  }

  double WayToTurn_m() const { return turn_at_m_ - (kMainStart_m + kEgoStart_m); }

  Json EgoPoints() const {
    if (turn_ == 0) return {{kMainStart_m, 0}, {main_end_m_, 0}};
    return {{kMainStart_m, 0}, {turn_at_m_, 0}, {turn_at_m_, turn_ * turn_end_m_}};
  }

  Json Route(const Json& points, double lateral_m, double start_m, const Json& speed) const {
    Json route = {{"points", points}};
    if (points.size() > 2) route["corner_m"] = kCorner_m;
    route["speed_mps"] = speed;
    route["start_m"] = Millis(start_m);
    route["lateral_m"] = Millis(lateral_m);
    return Json{{"route", route}};
  }

  Json Drive(BodyRequest& body, double speed_mps, double length_m) const {
    return SpeedKnots({speed_mps, 0, duration_s_, length_m}, body.rng);
  }

  // Follows the path of the camera some metres ahead, in its lane or the next, with the same speed
  // at the same place.
  std::optional<Json> Lead(BodyRequest& body) const {
    const double gap_m = body.keys.Number("gap_m", {3.0, 200.0});
    const bool in_next_lane = body.keys.BoolOr("in_next_lane", false);
    if (ego_mps_ < 0.5) return std::nullopt;
    return Route(EgoPoints(), in_next_lane ? lane_m_ : -lane_m_, kEgoStart_m + gap_m,
                 KnotsJson(ego_speed_, gap_m / ego_mps_));
  }

  // Meets the camera at a random time, on the main road or on the one that the camera turned into.
  std::optional<Json> Oncoming(BodyRequest& body) const {
    const double speed_mps = body.keys.Number("speed_mps", kBodySpeed_mps);
    const auto& ego = body.placed.camera().world_from_body;
    const double part = body.rng.Uniform(0.15, 1.0);
    const auto i = static_cast<std::size_t>(part * static_cast<double>(ego.size() - 1));
    const Eigen::Vector3d met = ego[i].translation();
    const bool turned = turn_ != 0 && std::abs(met.y()) > 20.0;
    const double from_end_m = turned ? turn_end_m_ - std::abs(met.y()) : main_end_m_ - met.x();
    const double start_m = from_end_m - speed_mps * part * duration_s_;
    if (start_m < 0.0) return std::nullopt;
    const double end = turned ? turn_ * turn_end_m_ : 0.0;
    const Json points = turned ? Json{{turn_at_m_, end}, {turn_at_m_, -turn_ * kSideHalf_m}}
                               : Json{{main_end_m_, 0}, {kMainStart_m, 0}};
    const double length_m = turned ? turn_end_m_ + kSideHalf_m : main_end_m_ - kMainStart_m;
    return Route(points, -lane_m_, start_m, Drive(body, speed_mps, 0.98 * length_m - start_m));
  }

  // Crosses the main road at a random time.
  std::optional<Json> Crossing(BodyRequest& body) const {
    const double speed_mps = body.keys.Number("speed_mps", kBodySpeed_mps);
    if (crossings_m_.empty()) return std::nullopt;
    const double x = crossings_m_[body.rng.UniformInt(crossings_m_.size())];
    const double up = body.rng.UniformInt(2) == 0 ? 1.0 : -1.0;
    const double start_m = kSideHalf_m - speed_mps * body.rng.Uniform(0.05, 1.0) * duration_s_;
    if (start_m < 0.0) return std::nullopt;
    const Json points = {{x, -up * kSideHalf_m}, {x, up * kSideHalf_m}};
    return Route(points, x == turn_at_m_ && turn_ != 0 ? -lane_m_ : -kSideLane_m, start_m,
                 Drive(body, speed_mps, 0.98 * 2.0 * kSideHalf_m - start_m));
  }

  // Passes the camera in the other lane.
  std::optional<Json> Overtaking(BodyRequest& body) const {
    constexpr double kFaster = 1.25;
    const double speed_mps =
        std::max(body.keys.Number("speed_mps", kBodySpeed_mps), kFaster * ego_mps_);
    if (turn_ != 0) return std::nullopt;
    const double start_m =
        kEgoStart_m - body.rng.Uniform(0.0, 0.6) * duration_s_ * (speed_mps - ego_mps_);
    if (start_m < 0.0) return std::nullopt;
    const double length_m = main_end_m_ - kMainStart_m;
    return Route(EgoPoints(), lane_m_, start_m, Drive(body, speed_mps, 0.98 * length_m - start_m));
  }

  std::optional<Json> Parked(BodyRequest& body) const {
    constexpr double kOffCorner_m = 15.0;
    const double x = body.rng.Uniform(kMainStart_m + kEgoStart_m, main_end_m_ - 15.0);
    const double side = body.rng.UniformInt(2) == 0 ? 1.0 : -1.0;
    for (const double crossing : crossings_m_) {
      if (std::abs(x - crossing) < kOffCorner_m) return std::nullopt;
    }
    return Json{
        {"still",
         {{"at", PointJson({x, side * kParked_m})}, {"heading_deg", side > 0.0 ? 180 : 0}}}};
  }

  double duration_s_;
  double width_m_ = 0.0;  // of the main road
  double lane_m_ = 0.0;   // from the middle of the road to that of a lane
  int turn_ = 0;          // 1 left, -1 right, 0 none
  double turn_at_m_ = 0.0;
  std::vector<double> crossings_m_;  // x of the crossing roads
  double main_end_m_ = 0.0;
  double turn_end_m_ = 0.0;
  double ego_mps_ = 0.0;
  std::vector<std::pair<double, double>> ego_speed_;  // time, speed
  Json street_;
  Json camera_;
};

}  // namespace

std::unique_ptr<Layout> MakeStreetLayout(double duration_s, ObjectReader& keys, Rng rng) {
  return std::make_unique<StreetLayout>(duration_s, keys, rng);
}

}  // namespace cvo::synth
