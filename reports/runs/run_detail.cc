// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/run_detail.h"

#include <functional>

#include "reports/results/run_summary.h"
#include "reports/results/timing.h"
#include "reports/runs/detail_files.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

// Only the frames of a result: everything else in it is large and read elsewhere.
struct FramesOfRun {
  static constexpr int kSchemaVersion = RunSummary::kSchemaVersion;
  static constexpr const char* kKind = RunSummary::kKind;

  std::vector<CameraFrame> frames;

  static Json Upgraded(Json json, const std::string&) { return json; }  // schema 2 has the same

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("frames", self.frames);
  }
};

void ReadTiming(const fs::path& file, RunDetail& detail) {
  const auto timing = ReadRecord<TimingData>(file);
  for (const auto& [stage, time] : timing.stages) {
    detail.stages.push_back({stage, time.median_ms, time.mean_ms, time.p95_ms});
  }
  detail.frames_per_second = timing.frames_per_second;
  detail.host = timing.host;
  detail.cpu = timing.cpu;
  detail.date = timing.date;
  detail.paths = timing.paths;
}

void ReadTruth(const fs::path& file, RunDetail& detail) {
  RunTruth truth = ReadTruthFile(file, detail.camera);
  for (std::size_t i = 0; i < detail.camera.size(); ++i) {
    detail.camera[i].truth = truth.camera[i];
  }
  detail.bodies = std::move(truth.bodies);
}

}  // namespace

RunDetail ReadRunDetail(const fs::path& run_folder) {
  RunDetail detail;
  detail.camera = ReadRecord<FramesOfRun>(run_folder / "result.json",
                                          {"bodies", "clusters", "metrics", "options"})
                      .frames;
  const auto read = [&](const char* name, const std::function<void(const fs::path&)>& reader) {
    const fs::path file = run_folder / name;
    try {
      if (!fs::exists(file)) {
        detail.missing.push_back(StrCat(name, ": no such file"));
      } else {
        reader(file);
      }
    } catch (const Error& error) {
      detail.missing.push_back(error.what());
    }
  };
  read("truth.json", [&](const fs::path& file) { ReadTruth(file, detail); });
  read("objects.csv", [&](const fs::path& file) { detail.clusters = ReadClusterTable(file); });
  read("timing.json", [&](const fs::path& file) { ReadTiming(file, detail); });
  return detail;
}

}  // namespace cvo::reports
