// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "reports/runs/detail_files.h"

namespace cvo::reports {
namespace {

constexpr int kTruthSchemaVersion = 1;

template <std::size_t kSize>
std::array<double, kSize> Numbers(const Json& json, const std::string& where) {
  std::array<double, kSize> numbers{};
  bool good = json.is_array() && json.size() == kSize;
  for (std::size_t i = 0; good && i < kSize; ++i) {
    good = json[i].is_number();
    if (good) numbers[i] = json[i].get<double>();
  }
  if (!good) ThrowError(where, json.dump().substr(0, 80), StrCat(kSize, " numbers"));
  return numbers;
}

class Reader {
 public:
  Reader(const std::vector<CameraFrame>& frames) : frames_(frames) {}

  BodyDetail Body(const Fields& fields) const {
    BodyDetail body;
    body.id = static_cast<int>(fields.Integer("id"));
    body.name = fields.Text("name");
    body.category = fields.Text("category");
    body.mover = fields.Bool("mover");
    body.diagonal_m = fields.Number("diagonal_m");
    body.cluster = fields.Integer("cluster");
    Truth(fields.Object("truth"), body);
    body.estimated = Positions(fields.Object("estimated"), body);
    body.predicted = Positions(fields.Object("predicted"), body);
    return body;
  }

 private:
  // The number in the folder of a frame given by its index.
  int Frame(const Json& json, const std::string& where) const {
    const bool good = json.is_number_integer() && json.get<std::int64_t>() >= 0 &&
                      json.get<std::int64_t>() < static_cast<std::int64_t>(frames_.size());
    if (!good) ThrowError(where, json.dump(), StrCat("one of ", frames_.size(), " frames"));
    return frames_[json.get<std::size_t>()].frame;
  }
  static const Json& ListLike(const Fields& fields, const char* key, const Json& frames) {
    const Json& list = fields.Array(key);
    if (list.size() != frames.size()) {
      ThrowError(StrCat(fields.where(), ", field ", key), StrCat(list.size(), " values"),
                 StrCat(frames.size(), ", one per frame"));
    }
    return list;
  }
  void Truth(const Fields& fields, BodyDetail& body) const {
    const Json& frames = fields.Array("frames");
    const Json& poses = ListLike(fields, "poses", frames);
    const Json& visible = ListLike(fields, "visible", frames);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const int frame = Frame(frames[i], fields.where() + ", frames");
      body.truth.emplace_back(frame, PoseOf(poses[i], fields.where() + ", poses"));
      if (visible[i] == true) body.visible.push_back(frame);
    }
    std::sort(body.truth.begin(), body.truth.end());
    std::sort(body.visible.begin(), body.visible.end());
  }
  std::vector<BodyPosition> Positions(const Fields& fields, const BodyDetail& body) const {
    const Json& frames = fields.Array("frames");
    const Json& positions = ListLike(fields, "positions_m", frames);
    std::vector<BodyPosition> list;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      BodyPosition position;
      position.frame = Frame(frames[i], fields.where() + ", frames");
      position.position_m = Numbers<3>(positions[i], fields.where() + ", positions_m");
      const auto truth = std::find_if(body.truth.begin(), body.truth.end(), [&](const auto& known) {
        return known.first == position.frame;
      });
      if (truth == body.truth.end()) {
        ThrowError(fields.where() + ", frames", frames[i].dump(), "a frame in which it has truth");
      }
      position.error_m = std::hypot(position.position_m[0] - truth->second[0],
                                    position.position_m[1] - truth->second[1],
                                    position.position_m[2] - truth->second[2]);
      list.push_back(position);
    }
    std::sort(list.begin(), list.end(),
              [](const auto& a, const auto& b) { return a.frame < b.frame; });
    return list;
  }

  const std::vector<CameraFrame>& frames_;
};

}  // namespace

Pose PoseOf(const Json& json, const std::string& where) { return Numbers<7>(json, where); }

RunTruth ReadTruthFile(const std::filesystem::path& file, const std::vector<CameraFrame>& frames) {
  const Json json = ReadJson(file);
  const Fields fields(json, file.string());
  fields.Check(kTruthSchemaVersion, "truth");
  RunTruth truth;
  for (const Json& pose : fields.Array("camera")) {
    truth.camera.emplace_back();
    if (!pose.is_null()) truth.camera.back() = PoseOf(pose, fields.where() + ", camera");
  }
  if (truth.camera.empty()) truth.camera.resize(frames.size());  // of bodies alone
  if (truth.camera.size() != frames.size()) {
    ThrowError(fields.where() + ", field camera", StrCat(truth.camera.size(), " poses"),
               StrCat(frames.size(), ", one per frame of result.json"));
  }
  const Reader reader(frames);
  for (const Json& body : fields.Array("bodies")) {
    truth.bodies.push_back(reader.Body({body, fields.where() + ", bodies"}));
  }
  return truth;
}

}  // namespace cvo::reports
