// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"
#include "tests/reports/results/result_files.h"

namespace cvo::test {

// The result folder of a suite of two scenes, two variants and `seeds` seeds. The ATE is
// 0.01 m * (1 + 0.1 * seed) on the first scene and ten times that on the second, at full coverage.
class GateFolder {
 public:
  explicit GateFolder(int seeds = 4) : seeds_(seeds) {
    ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
      WriteJob(scene, variant, seed);
    });
    WritePlan();
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  static std::string Id(const std::string& scene, const std::string& variant, int seed) {
    return StrCat(scene, "-", variant, "-", seed);
  }
  static double Ate(const std::string& scene, int seed) {
    return (scene == "room" ? 0.01 : 0.1) * (1.0 + 0.1 * seed);
  }

  void ForEachJob(
      const std::function<void(const std::string&, const std::string&, int)>& visit) const {
    for (const char* scene : {"room", "street"}) {
      for (int seed = 1; seed <= seeds_; ++seed) {
        for (const char* variant : {"full", "static"}) visit(scene, variant, seed);
      }
    }
  }

  // Applies `edit` to the result of the job with this id.
  void Edit(const std::string& id, const std::function<void(Json&)>& edit) const {
    const std::string name = "jobs/" + id + "/result.json";
    Json json = Json::parse(ReadFile(path() / name));
    edit(json);
    folder_.Write(name, json.dump());
  }
  // Metric 0 is the coverage, metric 1 the ATE.
  void EditMetric(const std::string& id, std::size_t metric, double value) const {
    Edit(id, [&](Json& result) { result["metrics"][metric]["value"] = value; });
  }
  void EditPlan(const std::function<void(Json&)>& edit) const {
    Json json = Json::parse(ReadFile(path() / "plan.json"));
    edit(json);
    folder_.Write("plan.json", json.dump());
  }
  void Write(const std::string& name, const std::string& content) const {
    folder_.Write(name, content);
  }

 private:
  void WriteJob(const std::string& scene, const std::string& variant, int seed) const {
    const std::string id = Id(scene, variant, seed);
    Json result = Result(scene, 60);
    result["job"] = id;
    result["variant"] = variant;
    result["seed"] = seed;
    result["sequence"]["content"] = "images of " + scene;
    result["build"]["commit"] = "0123456789abcdef";
    result["metrics"][1]["value"] = Ate(scene, seed);
    folder_.Write("jobs/" + id + "/result.json", result.dump());
  }

  void WritePlan() const {
    Json jobs = Json::array();
    ForEachJob([&](const std::string& scene, const std::string& variant, int seed) {
      jobs.push_back(PlannedJob(scene, variant, seed, Id(scene, variant, seed)));
    });
    const Json plan = {
        {"schema_version", 1},
        {"kind", "plan"},
        {"suite", {{"name", "gate"}, {"about", ""}}},
        {"build", "abc"},
        {"table", {{"rows", {"variant"}}, {"metrics", {"camera_ate"}}, {"reference", ""}}},
        {"jobs", jobs}};
    folder_.Write("plan.json", plan.dump());
  }

  int seeds_;
  TempFolder folder_;
};

}  // namespace cvo::test
