// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/scene_calibration.h"

#include <Eigen/Cholesky>
#include <array>
#include <numbers>

#include "core/files/json/json_record.h"

namespace cvo {
namespace {

// How the rendered right camera differs from the calibration, as the scene's manifest tells.
struct RightCameraError {
  double shift_px = 0.0;                 // of the principal point
  std::array<double, 3> rotation_deg{};  // about its x, y, z axes
  double focal = 0.0;                    // relative

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("shift_px", self.shift_px);
    archive.Field("rotation_deg", self.rotation_deg);
    archive.Field("focal", self.focal);
  }
};

RightCameraError ReadRightCameraError(const std::filesystem::path& manifest) {
  const Json json = ReadJson(manifest);
  if (!json.is_object() || !json.contains("rig_error")) return {};
  return FromJson<RightCameraError>(json.at("rig_error"), manifest.string() + ", rig_error");
}

// Returns how much further right a far point of the left image is in the right one than in a
// perfect pair, px.
double RightShiftOf(const RightCameraError& error, const StereoCamera& camera, double u, double v) {
  const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  const Eigen::Vector3d turn =
      Eigen::Vector3d(error.rotation_deg.data()) * std::numbers::pi / 180.0;
  const Eigen::Vector3d in_right = ExpSo3(turn).conjugate() * ray;
  const double u_right = camera.fx * (1.0 + error.focal) * in_right.x() / in_right.z() + camera.cx;
  return u_right + error.shift_px - u;
}

}  // namespace

std::optional<Vector6d> TrueRightField(const Sequence& sequence) {
  constexpr int kSteps = 20;
  const std::filesystem::path manifest = sequence.folder / "manifest.json";
  if (!std::filesystem::is_regular_file(manifest) ||
      !std::filesystem::is_regular_file(sequence.folder / "objects.csv") ||
      !PerturbationToJson(sequence.perturbation).empty()) {
    return std::nullopt;
  }
  const RightCameraError error = ReadRightCameraError(manifest);
  const StereoCamera& camera = sequence.camera;
  Matrix6d information = Matrix6d::Zero();
  Vector6d weighted = Vector6d::Zero();
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double u = static_cast<double>(i) / kSteps * (camera.width_px - 1);
      const double v = static_cast<double>(j) / kSteps * (camera.height_px - 1);
      const Vector6d basis = camera.BasisAt(u, v).value;
      information += basis * basis.transpose();
      weighted += basis * (RightShiftOf(error, camera, u, v) - camera.right_shift_px);
    }
  }
  return information.llt().solve(weighted);
}

}  // namespace cvo
