// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/truth/truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"

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
        body.visible_box = PixelBox{double(u), double(v), double(u), double(v)};
      }
      body.visible_box->left = std::min(body.visible_box->left, double(u));
      body.visible_box->right = std::max(body.visible_box->right, double(u));
      body.visible_box->bottom = v;
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
  body.amodal_box = ClipToImage(*projection.box(), world.rig.width_px, world.rig.height_px);
  const double whole_px2 = Area_px2(*projection.box());
  if (!body.amodal_box || !(whole_px2 > 0.0)) return;
  body.truncation = std::clamp(1.0 - Area_px2(*body.amodal_box) / whole_px2, 0.0, 1.0);
}

// Motion of a rigid surface to the next frame in the left camera's frame: p_next = R p + t.
struct Step {
  Eigen::Matrix3d R;
  Eigen::Vector3d t;
};

std::vector<Step> SurfaceSteps(const View& now, const View& next) {
  const RigidTransform next_left_from_world = next.world_from_left.Inverse();
  std::vector<Step> steps;
  const auto add = [&](const RigidTransform& world_from_surface_now,
                       const RigidTransform& world_from_surface_next) {
    const RigidTransform step = next_left_from_world * world_from_surface_next *
                                world_from_surface_now.Inverse() * now.world_from_left;
    steps.push_back({step.RotationMatrix(), step.translation()});
  };
  add(RigidTransform(), RigidTransform());
  for (std::size_t i = 0; i < now.world_from_body.size(); ++i) {
    add(now.world_from_body[i], next.world_from_body[i]);
  }
  return steps;
}

// Encodes in units of 1/64 px around 2^15; returns -1 if out of range.
int Encode(double flow_px) {
  const double code = std::round(flow_px * 64.0) + 32768.0;
  return code >= 0.0 && code <= 65535.0 ? static_cast<int>(code) : -1;
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

constexpr std::string_view kHeader =
    "frame,id,name,category,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,length_m,width_m,height_m,"
    "visible_px,alone_px,visible_fraction,truncation,visible_left,visible_top,visible_right,"
    "visible_bottom,amodal_left,amodal_top,amodal_right,amodal_bottom";

void AddNumber(double value, std::string& row) {
  row += ',';
  row += FormatDouble(value);
}

void AddVector(const Eigen::Vector3d& vector, std::string& row) {
  for (int i = 0; i < 3; ++i) AddNumber(vector[i], row);
}

void AddBox(const std::optional<PixelBox>& box, std::string& row) {
  if (!box) {
    row += ",,,,";
    return;
  }
  for (const double side : {box->left, box->top, box->right, box->bottom}) AddNumber(side, row);
}

Eigen::Vector3d ReadVector(const CsvFile& file, std::size_t row, std::size_t column) {
  return Eigen::Vector3d(file.Numbers<3>(row, column).data());
}

std::optional<PixelBox> ReadBox(const CsvFile& file, std::size_t row, std::size_t column) {
  if (file.Empty(row, column)) return std::nullopt;
  const auto [left, top, right, bottom] = file.Numbers<4>(row, column);
  return PixelBox{left, top, right, bottom};
}

BodyTruth ReadBody(const CsvFile& file, std::size_t row) {
  BodyTruth body;
  body.id = file.Integer(row, 1);
  const auto [qx, qy, qz, qw] = file.Numbers<4>(row, 7);
  body.state = {RigidTransform(Eigen::Quaterniond(qw, qx, qy, qz), ReadVector(file, row, 4)),
                ReadVector(file, row, 11), ReadVector(file, row, 14)};
  body.visible_px = file.Integer(row, 20);
  body.alone_px = file.Integer(row, 21);
  body.visible_fraction = file.Number(row, 22);
  body.truncation = file.Number(row, 23);
  body.visible_box = ReadBox(file, row, 24);
  body.amodal_box = ReadBox(file, row, 28);
  return body;
}

}  // namespace

void ProjectedBox::AddPoint(const Eigen::Vector3d& p) {
  const double u = rig_.fx * p.x() / p.z() + rig_.cx;
  const double v = rig_.fy * p.y() / p.z() + rig_.cy;
  if (!box_) box_ = PixelBox{u, v, u, v};
  box_->left = std::min(box_->left, u);
  box_->right = std::max(box_->right, u);
  box_->top = std::min(box_->top, v);
  box_->bottom = std::max(box_->bottom, v);
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

std::optional<PixelBox> ClipToImage(const PixelBox& box, int width_px, int height_px) {
  const PixelBox clipped = {std::max(box.left, 0.0), std::max(box.top, 0.0),
                            std::min(box.right, width_px - 1.0),
                            std::min(box.bottom, height_px - 1.0)};
  if (clipped.left > clipped.right || clipped.top > clipped.bottom) return std::nullopt;
  return clipped;
}

double IntersectionArea_px2(const PixelBox& a, const PixelBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0.0 && height > 0.0 ? width * height : 0.0;
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

cv::Mat ComputeFlow(const StereoCamera& rig, const Rendering& rendering, const View& now,
                    const View& next) {
  Require(now.world_from_body.size() == next.world_from_body.size(),
          "ComputeFlow: both views must have the same bodies");
  const std::vector<Step> steps = SurfaceSteps(now, next);
  cv::Mat flow(rendering.depth.size(), CV_16UC3, cv::Scalar::all(0));
  for (int v = 0; v < flow.rows; ++v) {
    const auto* depth = rendering.depth.ptr<float>(v);
    const auto* instance = rendering.instances.ptr<std::uint16_t>(v);
    auto* out = flow.ptr<cv::Vec3w>(v);
    for (int u = 0; u < flow.cols; ++u) {
      const double z = depth[u];
      if (!(z > 0.0)) continue;
      const Step& step = steps.at(instance[u]);
      const Eigen::Vector3d p =
          step.R * Eigen::Vector3d((u - rig.cx) * z / rig.fx, (v - rig.cy) * z / rig.fy, z) +
          step.t;
      if (!(p.z() > StereoCamera::kMinDepth_m)) continue;
      const int code_u = Encode(rig.fx * p.x() / p.z() + rig.cx - u);
      const int code_v = Encode(rig.fy * p.y() / p.z() + rig.cy - v);
      if (code_u < 0 || code_v < 0) continue;
      out[u] = cv::Vec3w(1, static_cast<std::uint16_t>(code_v), static_cast<std::uint16_t>(code_u));
    }
  }
  return flow;
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
    const PixelBox& box = *body.amodal_box;
    for (const double value :
         {alpha_rad, box.left, box.top, box.right, box.bottom, size_m.z(), size_m.y(), size_m.x(),
          bottom.x(), bottom.y(), bottom.z(), heading_rad}) {
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

std::string ObjectTableHeader() { return std::string(kHeader) + "\n"; }

std::string FormatObjectRows(const World& world, const FrameTruth& truth, int row_frame,
                             const RigidTransform& first_left_from_world) {
  std::string rows;
  for (const BodyTruth& body : truth.bodies) {
    const Body& described = world.bodies.at(static_cast<std::size_t>(body.id - 1));
    Require((described.name + described.category).find_first_of(", \t\n\"") == std::string::npos,
            "objects.csv: names and categories must have no blank, comma or quote");
    rows += StrCat(row_frame, ",", body.id, ",", described.name, ",", described.category);
    const RigidTransform pose = first_left_from_world * body.state.world_from_body;
    AddVector(pose.translation(), rows);
    for (int i = 0; i < 4; ++i) AddNumber(pose.data()[i], rows);
    AddVector(first_left_from_world.rotation() * body.state.velocity_in_world, rows);
    AddVector(first_left_from_world.rotation() * body.state.angular_velocity_in_world, rows);
    AddVector(described.size_m, rows);
    rows += StrCat(",", body.visible_px, ",", body.alone_px);
    AddNumber(body.visible_fraction, rows);
    AddNumber(body.truncation, rows);
    AddBox(body.visible_box, rows);
    AddBox(body.amodal_box, rows);
    rows += '\n';
  }
  return rows;
}

ObjectTable ReadObjectTable(const std::filesystem::path& path, const std::vector<double>& times_s) {
  const CsvFile file(path, kHeader);
  ObjectTable table;
  table.frames.resize(times_s.size());
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    table.frames[i].frame = static_cast<int>(i);
    table.frames[i].time_s = times_s[i];
  }
  for (std::size_t row = 0; row < file.rows(); ++row) {
    const int frame = file.Integer(row, 0);
    if (frame < 0 || frame >= static_cast<int>(times_s.size())) {
      file.Fail(row, StrCat("frame ", frame), "a frame of the folder");
    }
    std::vector<BodyTruth>& bodies = table.frames[static_cast<std::size_t>(frame)].bodies;
    bodies.push_back(ReadBody(file, row));
    if (bodies.back().id != static_cast<int>(bodies.size())) {
      file.Fail(row, StrCat("id ", bodies.back().id), "ids 1, 2, ...");
    }
    if (bodies.size() <= table.names.size()) continue;
    table.names.push_back(file.Name(row, 2));
    table.categories.push_back(file.Name(row, 3));
    table.sizes_m.push_back(ReadVector(file, row, 17));
  }
  return table;
}

}  // namespace cvo::synth
