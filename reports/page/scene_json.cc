// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <span>

#include "core/files/text/escape.h"
#include "reports/overlays/drawing/palette.h"
#include "reports/overlays/overlay_run.h"
#include "reports/page/page_parts.h"

namespace cvo::reports {
namespace {

using Indices = std::map<int, std::size_t>;  // index of each frame

double Millimetres(double metres) { return std::round(1e3 * metres); }

// Errors are stored at a finer resolution than positions.
Json Micrometres(double metres) {
  return std::isfinite(metres) ? Json(static_cast<std::int64_t>(std::round(1e6 * metres)))
                               : Json(nullptr);
}

Json CameraError(const CameraFrame& frame) {
  if (!frame.truth) return nullptr;
  const Pose& truth = *frame.truth;
  return Micrometres(std::hypot(frame.world_from_camera[0] - truth[0],
                                frame.world_from_camera[1] - truth[1],
                                frame.world_from_camera[2] - truth[2]));
}

void AddPosition(std::span<const double> metres, Json& list) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = Millimetres(metres[i]);
    // JSON has no NaN.
    list.push_back(std::isfinite(value) ? Json(static_cast<std::int64_t>(value)) : Json(nullptr));
  }
}

void AddRotation(const Pose& pose, Json& list) {
  for (std::size_t i = 3; i < 7; ++i) {
    list.push_back(std::isfinite(pose[i]) ? std::round(1e4 * pose[i]) / 1e4 : 0.0);
  }
}

// The colour as text; the same colours as on the images.
std::string Hex(const Rgb& colour) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  return text.data();
}

Json CameraJson(const RunDetail& detail) {
  Json estimated = Json::array();
  Json truth = Json::array();
  Json states = Json::array();
  Json errors = Json::array();
  bool any = false;
  for (const CameraFrame& frame : detail.camera) {
    AddPosition(frame.world_from_camera, estimated);
    states.push_back(frame.status);
    errors.push_back(CameraError(frame));
    any = any || frame.truth;
    if (frame.truth) {
      AddPosition(*frame.truth, truth);
    } else {
      for (int i = 0; i < 3; ++i) truth.push_back(nullptr);
    }
  }
  return {{"estimated", estimated},
          {"truth", any ? truth : Json(nullptr)},
          {"states", states},
          {"errors_um", errors}};
}

Json ClusterJson(std::int64_t id, std::int64_t color_id, const std::vector<const ClusterRow*>& rows,
                 const Indices& indices) {
  Json frames = Json::array();
  Json predicted = Json::array();
  Json positions = Json::array();
  Json rotations = Json::array();
  Json centers = Json::array();
  Json turns = Json::array();
  Json halves = Json::array();
  for (const ClusterRow* row : rows) {
    const auto index = indices.find(row->frame);
    if (index == indices.end()) continue;
    frames.push_back(index->second);
    predicted.push_back(row->predicted ? 1 : 0);
    AddPosition(row->world_from_object, positions);
    AddRotation(row->world_from_object, rotations);
    AddPosition(row->object_from_box, centers);
    AddRotation(row->object_from_box, turns);
    AddPosition(std::array{0.5 * row->size_m[0], 0.5 * row->size_m[1], 0.5 * row->size_m[2]},
                halves);
  }
  return {{"id", id},
          {"colour", Hex(ClusterColor(color_id))},
          {"category", rows.front()->category},
          {"frames", frames},
          {"predicted", predicted},
          {"positions", positions},
          {"rotations", rotations},
          {"centers", centers},
          {"turns", turns},
          {"halves", halves}};
}

Json ClustersJson(const RunDetail& detail, const Indices& indices) {
  std::map<std::int64_t, std::vector<const ClusterRow*>> by_id;
  for (const ClusterRow& row : detail.clusters) by_id[row.id].push_back(&row);
  Json clusters = Json::array();
  const std::map<std::int64_t, std::int64_t> colors = ApartColors(detail.clusters);
  for (const auto& [id, rows] : by_id) {
    const auto color = colors.find(id);
    clusters.push_back(ClusterJson(id, color == colors.end() ? id : color->second, rows, indices));
  }
  return clusters;
}

Json ErrorsJson(const std::vector<BodyPosition>& positions, const Indices& indices) {
  Json frames = Json::array();
  Json errors = Json::array();
  for (const BodyPosition& position : positions) {
    const auto index = indices.find(position.frame);
    if (index == indices.end() || !std::isfinite(position.error_m)) continue;
    frames.push_back(index->second);
    errors.push_back(Micrometres(position.error_m));
  }
  return {{"frames", frames}, {"um", errors}};
}

Json BodyJson(const BodyDetail& body, const Indices& indices) {
  Json frames = Json::array();
  Json positions = Json::array();
  for (const auto& [frame, pose] : body.truth) {
    const auto index = indices.find(frame);
    if (index == indices.end()) continue;
    frames.push_back(index->second);
    AddPosition(pose, positions);
  }
  return {{"id", body.id},
          {"name", body.name},
          {"mover", body.mover},
          {"cluster", body.cluster},
          {"frames", frames},
          {"positions", positions},
          {"errors", ErrorsJson(body.estimated, indices)},
          {"predicted", ErrorsJson(body.predicted, indices)}};
}

}  // namespace

Json SceneJson(const PageScene& scene) {
  Indices indices;
  Json frames = Json::array();
  Json times_ms = Json::array();
  for (const CameraFrame& frame : scene.detail.camera) {
    times_ms.push_back((frame.timestamp_ns - scene.detail.camera.front().timestamp_ns) / 1000000);
    indices.emplace(frame.frame, indices.size());
    frames.push_back(frame.frame);
  }
  Json bodies = Json::array();
  for (const BodyDetail& body : scene.detail.bodies) bodies.push_back(BodyJson(body, indices));
  Json images = Json::array();
  for (const PageImage& image : scene.images) {
    const auto index = indices.find(image.frame);
    if (index == indices.end()) continue;
    images.push_back({index->second, "data:image/jpeg;base64," + Base64(image.jpeg), image.alt});
  }
  return {{"frames", frames},
          {"times_ms", times_ms},
          {"camera", CameraJson(scene.detail)},
          {"clusters", ClustersJson(scene.detail, indices)},
          {"bodies", bodies},
          {"images", images}};
}

}  // namespace cvo::reports
