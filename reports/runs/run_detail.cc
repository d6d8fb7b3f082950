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

// Nothing but the frames: what else a result holds is large and for others.
std::vector<CameraFrame> ReadFrames(const fs::path& file) {
  const std::string where = file.string();
  const Json json = ReadJson(file, {"bodies", "clusters", "metrics", "options"});
  const Fields fields(json, where);
  fields.Check(kRunSchemaVersion, "run");
  std::vector<CameraFrame> frames;
  for (const Json& row : fields.Array("frames")) {
    const Fields entry(row, where + ", frames");
    CameraFrame frame;
    frame.frame = static_cast<int>(entry.Integer("frame"));
    frame.timestamp_ns = entry.Integer("timestamp_ns");
    frame.status = entry.Text("status");
    frame.world_from_camera = FromJson<Pose>(entry.Array("refined"), entry.where() + ", refined");
    frames.push_back(std::move(frame));
  }
  return frames;
}

void ReadTiming(const fs::path& file, RunDetail& detail) {
  const auto timing = ReadRecord<TimingData>(file);
  for (const auto& [stage, time] : timing.stages) {
    detail.stages.push_back({stage, time.median_ms, time.mean_ms, time.p95_ms});
  }
  detail.frames_per_second = timing.frames_per_second;
  detail.host = timing.host;
  detail.cpu = timing.cpu;
  detail.date = timing.date;
  detail.sequence_folder = timing.paths.sequence;
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
  detail.camera = ReadFrames(run_folder / "result.json");
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
