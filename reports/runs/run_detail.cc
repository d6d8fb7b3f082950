// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/run_detail.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/lists.h"
#include "core/files/text_file.h"
#include "core/record/run_summary.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

// Only the frames of a result: everything else in it is large and read elsewhere.
struct FramesOfRun {
  static constexpr int kSchemaVersion = RunSummary::kSchemaVersion;
  static constexpr const char* kKind = RunSummary::kKind;

  std::vector<CameraFrame> frames;

  CVO_FIELDS(frames);
};

// Reads the bodies of truth.json, whose frames are indices into the frames of the run.
class BodyReader {
 public:
  BodyReader(const std::vector<CameraFrame>& frames, std::string where)
      : frames_(frames), where_(std::move(where)) {}

  BodyDetail Body(const TruthOfBody& of) const {
    BodyDetail body{{of}, {}, {}, {}, {}};
    CheckLike(of.truth.frames, of.truth.poses, "truth", "poses");
    CheckLike(of.truth.frames, of.truth.visible, "truth", "visible");
    for (std::size_t i = 0; i < of.truth.frames.size(); ++i) {
      const int frame = Frame(of.truth.frames[i], "truth");
      body.truth.emplace_back(frame, of.truth.poses[i]);
      if (of.truth.visible[i]) body.visible.push_back(frame);
    }
    std::ranges::sort(body.truth);
    std::ranges::sort(body.visible);
    body.estimated = Positions(of.estimated, "estimated", body);
    body.predicted = Positions(of.predicted, "predicted", body);
    return body;
  }

 private:
  // Returns the number in the folder of the frame with this index.
  int Frame(int index, const char* list) const {
    if (index < 0 || index >= static_cast<int>(frames_.size())) {
      ThrowError(StrCat(where_, ", bodies, ", list, ", frames"), StrCat(index),
                 StrCat("one of ", frames_.size(), " frames"));
    }
    return frames_[static_cast<std::size_t>(index)].frame;
  }
  void CheckLike(const auto& frames, const auto& values, const char* list,
                 const char* field) const {
    if (values.size() == frames.size()) return;
    ThrowError(StrCat(where_, ", bodies, ", list, ", field ", field),
               StrCat(values.size(), " values"), StrCat(frames.size(), ", one per frame"));
  }
  std::vector<BodyPosition> Positions(const FramePositions& positions, const char* list,
                                      const BodyDetail& body) const {
    CheckLike(positions.frames, positions.positions_m, list, "positions_m");
    std::vector<BodyPosition> found;
    for (std::size_t i = 0; i < positions.frames.size(); ++i) {
      const int frame = Frame(positions.frames[i], list);
      const auto* truth = FindBy(body.truth, &std::pair<int, Pose>::first, frame);
      if (truth == nullptr) {
        ThrowError(StrCat(where_, ", bodies, ", list, ", frames"), StrCat(positions.frames[i]),
                   "a frame in which it has truth");
      }
      const Position& at = positions.positions_m[i];
      const Pose& pose = truth->second;
      found.push_back({frame, at, std::hypot(at[0] - pose[0], at[1] - pose[1], at[2] - pose[2])});
    }
    std::ranges::sort(found, {}, &BodyPosition::frame);
    return found;
  }

  const std::vector<CameraFrame>& frames_;
  std::string where_;
};

void ReadTruth(const fs::path& file, RunDetail& detail) {
  const auto data = ReadRecord<TruthData>(file);
  const BodyReader reader(detail.camera, file.string());
  std::vector<BodyDetail> bodies;
  for (const TruthOfBody& body : data.bodies) bodies.push_back(reader.Body(body));
  if (!data.camera.empty() && data.camera.size() != detail.camera.size()) {
    ThrowError(file.string() + ", field camera", StrCat(data.camera.size(), " poses"),
               StrCat(detail.camera.size(), ", one per frame of result.json"));
  }
  for (std::size_t i = 0; i < data.camera.size(); ++i) detail.camera[i].truth = data.camera[i];
  detail.bodies = std::move(bodies);
}

void ReadTiming(const fs::path& file, RunDetail& detail) {
  detail.timing = ReadRecord<TimingData>(file);
  detail.timing.frames = Json::array();
}

}  // namespace

std::vector<ObjectRow> ReadObjects(const fs::path& file) {
  std::vector<ObjectRow> rows;
  ReadCsv<ObjectRow>(file, [&rows](ObjectRow row, std::size_t) { rows.push_back(std::move(row)); });
  std::stable_sort(rows.begin(), rows.end(), [](const ObjectRow& a, const ObjectRow& b) {
    return std::pair(a.frame, a.id) < std::pair(b.frame, b.id);
  });
  return rows;
}

LandmarksByFrame ReadLandmarks(const fs::path& file, LandmarkLabel label) {
  LandmarksByFrame landmarks;
  ReadCsv<LandmarkRow>(file, [&](const LandmarkRow& row, std::size_t) {
    const auto& of = label == LandmarkLabel::kCluster ? row.cluster : row.inferred;
    landmarks[row.frame].push_back({static_cast<float>(row.z_px.x()),
                                    static_cast<float>(row.z_px.y()), of.value_or(kOutlierLabel),
                                    row.truth_body.value_or(-1), false});
  });
  return landmarks;
}

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
  read("objects.csv", [&](const fs::path& file) { detail.clusters = ReadObjects(file); });
  read("timing.json", [&](const fs::path& file) { ReadTiming(file, detail); });
  return detail;
}

}  // namespace cvo::reports
