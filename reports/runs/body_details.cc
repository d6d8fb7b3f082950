// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "reports/runs/detail_files.h"

namespace cvo::reports {
namespace {

class Reader {
 public:
  Reader(const std::vector<CameraFrame>& frames, std::string where)
      : frames_(frames), where_(std::move(where)) {}

  BodyDetail Body(const TruthOfBody& of) const {
    BodyDetail body;
    body.id = of.id;
    body.name = of.name;
    body.category = of.category;
    body.mover = of.mover;
    body.diagonal_m = of.diagonal_m;
    body.cluster = of.cluster;
    AddTruth(of.truth, body);
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
  void AddTruth(const TruthPoses& truth, BodyDetail& body) const {
    CheckLike(truth.frames.size(), truth.poses.size(), "truth", "poses");
    CheckLike(truth.frames.size(), truth.visible.size(), "truth", "visible");
    for (std::size_t i = 0; i < truth.frames.size(); ++i) {
      const int frame = Frame(truth.frames[i], "truth");
      body.truth.emplace_back(frame, truth.poses[i]);
      if (truth.visible[i]) body.visible.push_back(frame);
    }
    std::sort(body.truth.begin(), body.truth.end());
    std::sort(body.visible.begin(), body.visible.end());
  }
  std::vector<BodyPosition> Positions(const FramePositions& positions, const char* list,
                                      const BodyDetail& body) const {
    CheckLike(positions.frames.size(), positions.positions_m.size(), list, "positions_m");
    std::vector<BodyPosition> found;
    for (std::size_t i = 0; i < positions.frames.size(); ++i) {
      BodyPosition position;
      position.frame = Frame(positions.frames[i], list);
      position.position_m = positions.positions_m[i];
      const auto truth = std::find_if(body.truth.begin(), body.truth.end(), [&](const auto& known) {
        return known.first == position.frame;
      });
      if (truth == body.truth.end()) {
        ThrowError(StrCat(where_, ", bodies, ", list, ", frames"), StrCat(positions.frames[i]),
                   "a frame in which it has truth");
      }
      position.error_m = std::hypot(position.position_m[0] - truth->second[0],
                                    position.position_m[1] - truth->second[1],
                                    position.position_m[2] - truth->second[2]);
      found.push_back(position);
    }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.frame < b.frame; });
    return found;
  }

  const std::vector<CameraFrame>& frames_;
  std::string where_;
};

}  // namespace

RunTruth ReadTruthFile(const std::filesystem::path& file, const std::vector<CameraFrame>& frames) {
  const auto data = ReadRecord<TruthData>(file);
  RunTruth truth;
  truth.camera = data.camera;
  if (truth.camera.empty()) truth.camera.resize(frames.size());  // only bodies have truth
  if (truth.camera.size() != frames.size()) {
    ThrowError(file.string() + ", field camera", StrCat(truth.camera.size(), " poses"),
               StrCat(frames.size(), ", one per frame of result.json"));
  }
  const Reader reader(frames, file.string());
  for (const TruthOfBody& body : data.bodies) truth.bodies.push_back(reader.Body(body));
  return truth;
}

}  // namespace cvo::reports
