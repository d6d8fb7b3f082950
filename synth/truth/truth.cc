// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/truth/truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/record/csv_rows.h"

namespace cvo::synth {
namespace {

constexpr double kNearest_m = StereoCamera::kMinDepth_m;

// Intersection of the line from a to b with the near plane.
Eigen::Vector3d AtNearPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double s = (kNearest_m - a.z()) / (b.z() - a.z());
  Eigen::Vector3d p = a + s * (b - a);
  p.z() = kNearest_m;
  return p;
}

// Finds the pixel counts and boxes of all bodies in one pass over the mask.
void AddMasks(const cv::Mat& instances, std::vector<BodyTruth>& bodies) {
  for (int v = 0; v < instances.rows; ++v) {
    const auto* row = instances.ptr<std::uint16_t>(v);
    for (int u = 0; u < instances.cols; ++u) {
      if (row[u] == 0) continue;
      Require(row[u] <= bodies.size(), "ComputeTruth: an instance mask names an unknown body");
      BodyTruth& body = bodies[row[u] - 1U];
      ++body.visible_px;
      if (!body.visible_box) {
        body.visible_box = ImageBox{double(u), double(v), double(u), double(v)};
      }
      body.visible_box->left_px = std::min(body.visible_box->left_px, double(u));
      body.visible_box->right_px = std::max(body.visible_box->right_px, double(u));
      body.visible_box->bottom_px = v;
    }
  }
}

void AddAmodalBox(const World& world, const RigidTransform& left_from_world, BodyTruth& body) {
  ProjectedBox projection(world.rig);
  const RigidTransform left_from_body = left_from_world * body.state.world_from_body;
  for (const Drawable& drawable : world.drawables) {
    if (drawable.body != body.id) continue;
    projection.Add(world.meshes.at(static_cast<std::size_t>(drawable.mesh)), left_from_body);
  }
  if (!projection.box()) return;
  body.amodal_box = ClipToImage(*projection.box(), world.rig);
  const double whole_px2 = projection.box()->Width() * projection.box()->Height();
  if (!body.amodal_box || !(whole_px2 > 0.0)) return;
  body.truncation =
      std::clamp(1.0 - body.amodal_box->Width() * body.amodal_box->Height() / whole_px2, 0.0, 1.0);
}

int Occlusion(const BodyTruth& body) {
  if (body.visible_px == 0) return 3;
  if (body.visible_fraction >= 0.8) return 0;
  return body.visible_fraction >= 0.3 ? 1 : 2;
}

double WrapAngle(double angle_rad) { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

std::string ProjectionRow(const char* name, const StereoCamera& rig, double baseline_m) {
  std::string row = name;
  for (const double value :
       {rig.fx, 0.0, rig.cx, -rig.fx * baseline_m, 0.0, rig.fy, rig.cy, 0.0, 0.0, 0.0, 1.0, 0.0}) {
    row += StrCat(" ", FormatDouble(value == 0.0 ? 0.0 : value));
  }
  return row += '\n';
}

}  // namespace

void ProjectedBox::AddPoint(const Eigen::Vector3d& p) {
  const double u = rig_.fx * p.x() / p.z() + rig_.cx;
  const double v = rig_.fy * p.y() / p.z() + rig_.cy;
  if (!box_) box_ = ImageBox{u, v, u, v};
  box_->left_px = std::min(box_->left_px, u);
  box_->right_px = std::max(box_->right_px, u);
  box_->top_px = std::min(box_->top_px, v);
  box_->bottom_px = std::max(box_->bottom_px, v);
}

void ProjectedBox::Add(const Mesh& mesh, const RigidTransform& camera_from_mesh) {
  const Eigen::Matrix3d R = camera_from_mesh.RotationMatrix();
  const Eigen::Vector3d t = camera_from_mesh.translation();
  std::vector<Eigen::Vector3d> points;
  points.reserve(mesh.vertices.size());
  bool all_in_front = true;
  for (const Vertex& vertex : mesh.vertices) {
    points.emplace_back(R * vertex.position.cast<double>() + t);
    if (points.back().z() >= kNearest_m) {
      AddPoint(points.back());
    } else {
      all_in_front = false;
    }
  }
  if (all_in_front) return;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& a = points[mesh.indices[i + k]];
      const Eigen::Vector3d& b = points[mesh.indices[i + (k + 1) % 3]];
      if ((a.z() >= kNearest_m) != (b.z() >= kNearest_m)) AddPoint(AtNearPlane(a, b));
    }
  }
}

FrameTruth ComputeTruth(const World& world, int frame, const Rendering& rendering) {
  Require(rendering.instances.type() == CV_16UC1, "ComputeTruth: the mask must be 16 bits");
  Require(rendering.alone_px.size() == world.bodies.size(),
          "ComputeTruth: alone_px must have one number for each body");
  FrameTruth truth;
  truth.frame = frame;
  truth.time_s = world.Time_s(frame);
  truth.world_from_left = world.camera->At(truth.time_s).world_from_body;
  for (const Body& body : world.bodies) {
    BodyTruth& added = truth.bodies.emplace_back();
    added.id = body.id;
    added.state = body.motion->At(truth.time_s);
    added.alone_px = rendering.alone_px[truth.bodies.size() - 1];
  }
  AddMasks(rendering.instances, truth.bodies);
  const RigidTransform left_from_world = truth.world_from_left.Inverse();
  for (BodyTruth& body : truth.bodies) {
    // Drawn alone, a body may gain or lose a pixel at its rim compared with the whole scene.
    body.alone_px = std::max(body.alone_px, body.visible_px);
    if (body.alone_px > 0) body.visible_fraction = double(body.visible_px) / body.alone_px;
    AddAmodalBox(world, left_from_world, body);
  }
  return truth;
}

std::string FormatLabels(const World& world, const FrameTruth& truth, int row_frame) {
  std::string rows;
  const RigidTransform left_from_world = truth.world_from_left.Inverse();
  for (const BodyTruth& body : truth.bodies) {
    if (!body.amodal_box) continue;
    const Body& described = world.bodies.at(static_cast<std::size_t>(body.id - 1));
    const RigidTransform left_from_body = left_from_world * body.state.world_from_body;
    const Eigen::Vector3d size_m = described.size_m;
    const Eigen::Vector3d bottom = left_from_body * Eigen::Vector3d(0.0, 0.0, -size_m.z() / 2.0);
    const Eigen::Vector3d forward = left_from_body.rotation() * Eigen::Vector3d::UnitX();
    const double heading_rad = std::atan2(-forward.z(), forward.x());
    const double alpha_rad = WrapAngle(heading_rad - std::atan2(bottom.x(), bottom.z()));
    rows += StrCat(row_frame, " ", body.id, " ", described.category, " ",
                   FormatFixed(body.truncation, 6), " ", Occlusion(body));
    const ImageBox& box = *body.amodal_box;
    for (const double value :
         {alpha_rad, box.left_px, box.top_px, box.right_px, box.bottom_px, size_m.z(), size_m.y(),
          size_m.x(), bottom.x(), bottom.y(), bottom.z(), heading_rad}) {
      rows += StrCat(" ", FormatFixed(value, 6));
    }
    rows += '\n';
  }
  return rows;
}

std::string FormatKittiPose(const RigidTransform& world_from_camera) {
  const Eigen::Matrix4d matrix = world_from_camera.Matrix();
  std::string row;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) row += StrCat(row.empty() ? "" : " ", FormatDouble(matrix(r, c)));
  }
  return row += '\n';
}

std::string FormatKittiCalibration(const StereoCamera& rig) {
  Require(rig.right_shift_px == 0.0, "calib.txt: a rendered pair has no rectification error");
  return ProjectionRow("P0:", rig, 0.0) + ProjectionRow("P1:", rig, rig.baseline_m) +
         ProjectionRow("P2:", rig, 0.0) + ProjectionRow("P3:", rig, rig.baseline_m);
}

std::string SixDigits(int number) {
  std::string digits = std::to_string(number);
  if (digits.size() < 6) digits.insert(0, 6 - digits.size(), '0');
  return digits;
}

std::string ObjectTableHeader() { return CsvHeader<SceneBody>() + "\n"; }

std::string FormatObjectRows(const World& world, const FrameTruth& truth, int row_frame,
                             const RigidTransform& first_left_from_world) {
  std::string rows;
  for (const BodyTruth& body : truth.bodies) {
    const Body& described = world.bodies.at(static_cast<std::size_t>(body.id - 1));
    Require((described.name + described.category).find_first_of(", \t\n\"") == std::string::npos,
            "objects.csv: names and categories must have no blank, comma or quote");
    SceneBody row;
    row.frame = row_frame;
    row.id = body.id;
    row.name = described.name;
    row.category = described.category;
    row.world_from_object = first_left_from_world * body.state.world_from_body;
    row.velocity_in_world = first_left_from_world.rotation() * body.state.velocity_in_world;
    row.angular_velocity_in_world =
        first_left_from_world.rotation() * body.state.angular_velocity_in_world;
    row.size_m = described.size_m;
    row.visible_px = body.visible_px;
    row.alone_px = body.alone_px;
    row.visible_fraction = body.visible_fraction;
    row.truncation = body.truncation;
    row.visible_box = body.visible_box;
    row.amodal_box = body.amodal_box;
    rows += CsvLine(row);
  }
  return rows;
}

ObjectTable ReadObjectTable(const std::filesystem::path& path, const std::vector<double>& times_s) {
  ObjectTable table;
  table.frames.resize(times_s.size());
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    table.frames[i].frame = static_cast<int>(i);
    table.frames[i].time_s = times_s[i];
  }
  ReadCsv<SceneBody>(path, [&](const SceneBody& row, std::size_t index) {
    const std::string where = StrCat(path.string(), ":", index + 2);
    if (row.frame < 0 || row.frame >= static_cast<int>(times_s.size())) {
      ThrowError(where, StrCat("frame ", row.frame), "a frame of the folder");
    }
    std::vector<BodyTruth>& bodies = table.frames[static_cast<std::size_t>(row.frame)].bodies;
    bodies.push_back({row.id,
                      {row.world_from_object, row.velocity_in_world, row.angular_velocity_in_world},
                      row.visible_px,
                      row.alone_px,
                      row.visible_fraction,
                      row.truncation,
                      row.visible_box,
                      row.amodal_box});
    if (row.id != static_cast<int>(bodies.size())) {
      ThrowError(where, StrCat("id ", row.id), "ids 1, 2, ...");
    }
    if (bodies.size() <= table.categories.size()) return;
    table.categories.push_back(row.category);
    table.sizes_m.push_back(row.size_m);
  });
  return table;
}

}  // namespace cvo::synth
