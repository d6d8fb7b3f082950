// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/temp_folder.h"

namespace cvo::test {

using Json = nlohmann::ordered_json;

inline Json MetricOf(const std::string& name, double value, const std::string& unit,
                     const std::string& aggregation) {
  return {{"name", name},
          {"value", value},
          {"unit", unit},
          {"n", 108},
          {"contract",
           {{"subject", "left camera"},
            {"poses", "refined"},
            {"truth", "devkit"},
            {"right_shift_px", 0.0},
            {"alignment", "SE(3) over positions, Umeyama without scale"},
            {"pairing", "all frames with truth and estimate"},
            {"delta", "none"},
            {"aggregation", aggregation}}},
          {"left_out", "1 frame"}};
}

// The part of a result.json that tables read, with camera coverage and ATE over 108 frames.
inline Json Result(const std::string& sequence = "2011_09_26_drive_0001", int frames = 108) {
  Json coverage = MetricOf("camera_coverage", 1.0, "1", "fraction with an estimate");
  coverage["contract"]["alignment"] = "none";
  coverage["contract"]["pairing"] = "all frames with truth";
  return {{"schema_version", 3},
          {"kind", "run"},
          {"job", "job of " + sequence},
          {"status", "ok"},
          {"message", ""},
          {"variant", "static"},
          {"seed", 0},
          {"sequence",
           {{"name", sequence},
            {"type", "kitti-raw"},
            {"pair", "grey"},
            {"first_frame", 0},
            {"frames", frames},
            {"total_frames", frames},
            {"content", "images of " + sequence}}},
          {"options", {{"orb", {{"features", 2000}}}}},
          {"build", {{"identity", "abc"}}},
          {"metrics",
           {coverage, MetricOf("camera_ate", 0.0625, "m", "root mean square of position errors")}},
          {"bodies", nullptr},
          {"frames", {{{"frame", 0}, {"note", "braces } ] and \" \\ in a text"}}}}};
}

// A body with these position errors in frames 0, 1, ...; a negative error marks a frame without an
// estimate.
inline Json BodyOf(int id, const std::vector<double>& errors_m) {
  Json frames = Json::array();
  Json positions_m = Json::array();
  double sum = 0.0;
  for (std::size_t i = 0; i < errors_m.size(); ++i) {
    if (errors_m[i] < 0.0) continue;
    frames.push_back(i);
    positions_m.push_back(errors_m[i]);
    sum += errors_m[i] * errors_m[i];
  }
  const auto n = static_cast<double>(frames.size());
  return {{"id", id},
          {"name", "body"},
          {"category", "car"},
          {"mover", true},
          {"travel_m", 3.0},
          {"cluster", n > 0.0 ? id : -1},
          {"visible_frames", errors_m.size()},
          {"estimated_frames", frames.size()},
          {"id_switches", 1},
          {"fragments", 0},
          {"ate_m", n > 0.0 ? Json(std::sqrt(sum / n)) : Json(nullptr)},
          {"predicted_ate_m", nullptr},
          {"velocity_m_s", nullptr},
          {"all_pairs_rad", nullptr},
          {"all_pairs_m", nullptr},
          {"one_frame_rad", nullptr},
          {"one_frame_m", nullptr},
          {"motion_rad", nullptr},
          {"motion_m", nullptr},
          {"errors", {{"frames", frames}, {"position_m", positions_m}}},
          {"predicted", {{"frames", Json::array()}, {"position_m", Json::array()}}}};
}

// Adds bodies and body metrics. The values of the metrics are 0, as tables compute them from the
// bodies.
inline Json WithBodies(Json result, const Json& bodies) {
  result["bodies"] = {{"refined", bodies}, {"causal", Json::array()}};
  result["metrics"].push_back(
      MetricOf("object_ate", 0.0, "m", "root mean square per body, mean over bodies"));
  const std::string fraction = "fraction with an estimate";
  result["metrics"].push_back(MetricOf("object_success_10cm", 0.0, "1", fraction));
  result["metrics"].push_back(MetricOf("object_coverage", 0.0, "1", fraction));
  return result;
}

// A timing.json with one stage of this median time.
inline Json TimingOf(const std::string& stage, double median_ms) {
  return {
      {"schema_version", 1},
      {"kind", "timing"},
      {"job", "a"},
      {"date", "2026-01-02T03:04:05Z"},
      {"host", "here"},
      {"cpu", "one of 3 GHz"},
      {"cpus", 2},
      {"threads", 1},
      {"paths", {{"sequence", "/data/room"}, {"output", "/out"}}},
      {"peak_memory_mb", 100.0},
      {"wall_s", 8.0},
      {"frames_per_second", 12.5},
      {"stages",
       {{stage, {{"median_ms", median_ms}, {"mean_ms", 2.5}, {"p95_ms", 4.0}, {"total_ms", 9.0}}}}},
      {"frames", Json::array()}};
}

// A job of a plan.json, as reports read it.
inline Json PlannedJob(const std::string& sequence, const std::string& variant, int seed,
                       const std::string& id) {
  return {{"sequence", sequence},
          {"detections", "good"},
          {"variant", variant},
          {"system", ""},
          {"seed", seed},
          {"oracle", Json::array()},
          {"parameters", Json::object()},
          {"missing", ""},
          {"job", id}};
}

// The result folder of a suite: jobs are added one by one, then Written() writes the plan.
class SuiteResults {
 public:
  std::string name = "small";
  Json table = {{"rows", {"sequence", "variant"}},
                {"metrics", {"camera_ate", "object_ate", "object_success_10cm"}},
                {"reference", ""}};

  // Adds a job without a result to the plan.
  Json& Plan(const std::string& sequence, const std::string& variant, int seed = 0) {
    jobs_.push_back(PlannedJob(sequence, variant, seed, "job" + std::to_string(jobs_.size())));
    return jobs_.back();
  }
  // Adds a job with its result to the plan.
  Json& Add(Json result, const std::string& variant = "static", int seed = 0) {
    Json& job = Plan(result["sequence"]["name"], variant, seed);
    result["job"] = job["job"];
    result["variant"] = variant;
    result["seed"] = seed;
    AddText(result.dump());
    return job;
  }
  // Writes `text` as the result of the last job of the plan.
  void AddText(const std::string& text) {
    const std::string job = jobs_.back()["job"];
    folder_.Write("jobs/" + job + "/result.json", text);
  }
  void AddFailure(const std::string& message) {
    const std::string job = jobs_.back()["job"];
    const Json failure = {{"schema_version", 1},
                          {"kind", "failure"},
                          {"job", job},
                          {"message", message},
                          {"log", "logs/x.log"}};
    folder_.Write("failed/" + job + ".json", failure.dump());
  }
  const std::filesystem::path& Written() const {
    const Json plan = {{"schema_version", 1},
                       {"kind", "plan"},
                       {"suite", {{"name", name}, {"about", "what it is"}}},
                       {"build", "abc"},
                       {"table", table},
                       {"jobs", jobs_}};
    folder_.Write("plan.json", plan.dump());
    return folder_.path();
  }
  const TempFolder& folder() const { return folder_; }

 private:
  TempFolder folder_;
  Json jobs_ = Json::array();
};

}  // namespace cvo::test
