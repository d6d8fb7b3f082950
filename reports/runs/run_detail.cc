// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/run_detail.h"

#include <algorithm>
#include <array>
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
    CheckLike(of.truth.frames.size(), of.truth.poses.size(), "truth", "poses");
    CheckLike(of.truth.frames.size(), of.truth.visible.size(), "truth", "visible");
    for (std::size_t i = 0; i < of.truth.frames.size(); ++i) {
      const int frame = Frame(of.truth.frames[i], "truth");
      body.truth.emplace_back(frame, of.truth.poses[i]);
      if (of.truth.visible[i]) body.visible.push_back(frame);
    }
    std::sort(body.truth.begin(), body.truth.end());
    std::sort(body.visible.begin(), body.visible.end());
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
  void CheckLike(std::size_t frames, std::size_t values, const char* list,
                 const char* field) const {
    if (values == frames) return;
    ThrowError(StrCat(where_, ", bodies, ", list, ", field ", field), StrCat(values, " values"),
               StrCat(frames, ", one per frame"));
  }
  std::vector<BodyPosition> Positions(const FramePositions& positions, const char* list,
                                      const BodyDetail& body) const {
    CheckLike(positions.frames.size(), positions.positions_m.size(), list, "positions_m");
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
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.frame < b.frame; });
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

// Returns the cluster with most landmarks; -1 if none has enough. On a tie, the last one wins, else
// the lower id.
std::int64_t BestCluster(const std::map<std::int64_t, int>& landmarks, std::int64_t last) {
  constexpr int kMinObservedLandmarks = 3;
  std::int64_t best = -1;
  int most = kMinObservedLandmarks - 1;
  for (const auto& [cluster, count] : landmarks) {
    if (count > most || (count == most && best != -1 && cluster == last)) {
      best = cluster;
      most = count;
    }
  }
  return best;
}

class ClusterTable {
 public:
  explicit ClusterTable(const fs::path& file) : csv_(file) {}

  std::size_t rows() const { return csv_.rows(); }
  ClusterRow Row(std::size_t i) const {
    ClusterRow row;
    row.frame = csv_.Integer(i, frame_);
    row.id = csv_.Id(i, id_);
    row.category = csv_.Text(i, category_);
    row.predicted = csv_.Text(i, status_) == "predicted";
    // Refined values are empty if the run never returned to the frame; then those from when the
    // frame arrived are used.
    const bool refined = !csv_.Empty(i, refined_pose_);
    row.world_from_object = csv_.Numbers<7>(i, refined ? refined_pose_ : pose_);
    row.velocity_m_s = csv_.Numbers<3>(i, refined ? refined_velocity_ : velocity_);
    AddBox(i, row);
    row.observed_landmarks = csv_.Integer(i, observed_);
    return row;
  }

 private:
  // Older tables only have the extent along the axes of the object frame.
  void AddBox(std::size_t i, ClusterRow& row) const {
    if (box_) {
      row.object_from_box = csv_.Numbers<7>(i, *box_);
      row.size_m = csv_.Numbers<3>(i, *box_ + 7);
      return;
    }
    const std::array<double, 6> extent = csv_.Numbers<6>(i, extent_);
    row.object_from_box = {extent[0], extent[1], extent[2], 0.0, 0.0, 0.0, 1.0};
    row.size_m = {2.0 * extent[3], 2.0 * extent[4], 2.0 * extent[5]};
  }

  CsvFile csv_;
  // The first column of each group.
  std::size_t frame_ = csv_.Column("frame");
  std::size_t id_ = csv_.Column("id");
  std::size_t category_ = csv_.Column("category");
  std::size_t status_ = csv_.Column("status");
  std::size_t pose_ = csv_.Columns({"x", "y", "z", "qx", "qy", "qz", "qw"});
  std::size_t velocity_ = csv_.Columns({"vx", "vy", "vz"});
  std::size_t refined_pose_ = csv_.Columns({"refined_x", "refined_y", "refined_z", "refined_qx",
                                            "refined_qy", "refined_qz", "refined_qw"});
  std::size_t refined_velocity_ = csv_.Columns({"refined_vx", "refined_vy", "refined_vz"});
  std::size_t extent_ =
      csv_.Columns({"center_x", "center_y", "center_z", "half_x_m", "half_y_m", "half_z_m"});
  std::optional<std::size_t> box_ =
      csv_.Has("box_x")
          ? std::optional(csv_.Columns({"box_x", "box_y", "box_z", "box_qx", "box_qy", "box_qz",
                                        "box_qw", "length_m", "height_m", "width_m"}))
          : std::nullopt;
  std::size_t observed_ = csv_.Column("observed_landmarks");
};

}  // namespace

std::vector<ClusterRow> ReadClusterTable(const fs::path& file) {
  const ClusterTable table(file);
  std::vector<ClusterRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) rows.push_back(table.Row(i));
  std::stable_sort(rows.begin(), rows.end(), [](const ClusterRow& a, const ClusterRow& b) {
    return std::pair(a.frame, a.id) < std::pair(b.frame, b.id);
  });
  return rows;
}

LandmarksByFrame ReadLandmarks(const fs::path& file, LandmarkLabel label) {
  const CsvFile csv(file);
  const std::size_t frame = csv.Column("frame");
  const std::size_t u = csv.Column("u_px");
  const std::size_t v = csv.Column("v_px");
  const std::size_t of = csv.Column(label == LandmarkLabel::kCluster ? "cluster" : "inferred");
  const std::size_t body = csv.Column("truth_body");
  LandmarksByFrame landmarks;
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    LandmarkRow row;
    row.u_px = static_cast<float>(csv.Number(i, u));
    row.v_px = static_cast<float>(csv.Number(i, v));
    if (!csv.Empty(i, of)) row.label = csv.Id(i, of);
    if (!csv.Empty(i, body)) row.truth_body = csv.Integer(i, body);
    landmarks[csv.Integer(i, frame)].push_back(row);
  }
  return landmarks;
}

std::vector<IdentitySwitch> IdentitySwitches(const LandmarksByFrame& landmarks,
                                             const std::vector<BodyDetail>& bodies) {
  std::vector<IdentitySwitch> switches;
  for (const BodyDetail& body : bodies) {
    std::int64_t last = -1;
    for (const int frame : body.visible) {
      const auto seen = landmarks.find(frame);
      if (seen == landmarks.end()) continue;
      std::map<std::int64_t, int> counts;  // by cluster
      for (const LandmarkRow& landmark : seen->second) {
        if (landmark.truth_body == body.id && landmark.label > 0) ++counts[landmark.label];
      }
      const std::int64_t best = BestCluster(counts, last);
      if (best == -1) continue;
      if (last != -1 && best != last) switches.push_back({frame, body.id, last, best});
      last = best;
    }
  }
  return switches;
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
  read("objects.csv", [&](const fs::path& file) { detail.clusters = ReadClusterTable(file); });
  read("timing.json", [&](const fs::path& file) { ReadTiming(file, detail); });
  return detail;
}

}  // namespace cvo::reports
