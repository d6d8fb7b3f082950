// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/truth/labels.h"

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/files/text/number.h"

namespace cvo::synth {
namespace {

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

}  // namespace cvo::synth
