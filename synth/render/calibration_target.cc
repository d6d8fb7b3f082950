// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/calibration_target.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cvo::synth {
namespace {

constexpr int kColumns = 7;  // number of squares
constexpr int kRows = 5;
constexpr double kSquare_m = 0.1;
constexpr int kSquare_px = 64;  // in the texture
constexpr double kRamp_px = 5.0;
constexpr double kSmallestSquare_px = 24.0;  // in the image, so that corner windows do not touch
constexpr int kTextureSide_px = 1024;
// Grey levels that leave room for noise and interpolation on both sides.
constexpr int kDark = 40;
constexpr int kBright = 215;

double CornerX(int column) { return (column - 0.5 * kColumns) * kSquare_m; }
double CornerY(int row) { return (row - 0.5 * kRows) * kSquare_m; }

// 1 in the middle of even squares, -1 in the middle of odd ones, 0 on the edge between them.
double Wave(double texel) {
  const double square = std::floor(texel / kSquare_px);
  const double in_square = texel - square * kSquare_px;
  const double from_edge = std::min(in_square, kSquare_px - in_square);
  const double height = std::min(1.0, from_edge / kRamp_px);
  return static_cast<int>(square) % 2 == 0 ? height : -height;
}

// Draws the edges as ramps in a texture. Texture filtering places an edge more precisely than four
// samples per pixel place the edge of a triangle, and a ramp over some pixels more precisely than a
// step.
cv::Mat PatternTexture() {
  cv::Mat texture(kTextureSide_px, kTextureSide_px, CV_8UC3);
  for (int row = 0; row < kTextureSide_px; ++row) {
    for (int column = 0; column < kTextureSide_px; ++column) {
      const double wave = Wave(column + 0.5) * Wave(row + 0.5);
      const double grey = 0.5 * (kDark + kBright) - 0.5 * (kBright - kDark) * wave;
      texture.at<cv::Vec3b>(row, column) = cv::Vec3b::all(static_cast<uchar>(std::lround(grey)));
    }
  }
  return texture;
}

Mesh BoardMesh() {
  Mesh mesh;
  for (int row : {0, kRows}) {
    for (int column : {0, kColumns}) {
      Vertex vertex;
      vertex.position = Eigen::Vector3d(CornerX(column), CornerY(row), 0.0).cast<float>();
      vertex.normal = -Eigen::Vector3f::UnitZ();
      vertex.uv = Eigen::Vector2d(column, row).cast<float>() * kSquare_px / kTextureSide_px;
      mesh.vertices.push_back(vertex);
    }
  }
  mesh.indices = {0, 1, 2, 1, 3, 2};
  return mesh;
}

// Pose of the board relative to the midpoint between the cameras: where its centre appears, as a
// fraction of the image size; the side of a square seen from the front; and the rotation of the
// board, degrees.
struct Placement {
  double u;
  double v;
  double square;  // as a fraction of the image height
  double tilt_x_deg;
  double tilt_y_deg;
  double roll_deg;
};

constexpr std::array<Placement, 8> kPlacements = {{{0.50, 0.50, 0.100, 0.0, 0.0, 7.0},
                                                   {0.50, 0.50, 0.070, 35.0, 0.0, 13.0},
                                                   {0.52, 0.48, 0.070, 0.0, 40.0, -11.0},
                                                   {0.30, 0.32, 0.055, 20.0, -25.0, 33.0},
                                                   {0.72, 0.30, 0.055, -25.0, 20.0, -29.0},
                                                   {0.32, 0.70, 0.055, -30.0, -15.0, 17.0},
                                                   {0.70, 0.68, 0.055, 25.0, 30.0, 41.0},
                                                   {0.55, 0.45, 0.050, 10.0, -10.0, 22.0}}};

View Place(const StereoCamera& rig, const Placement& placement) {
  const double square_px = std::max(kSmallestSquare_px, placement.square * rig.height_px);
  const double depth = rig.fy * kSquare_m / square_px;
  const Eigen::Vector3d board_in_left((placement.u * rig.width_px - rig.cx) / rig.fx * depth,
                                      (placement.v * rig.height_px - rig.cy) / rig.fy * depth,
                                      depth);
  const double rad = std::acos(-1.0) / 180.0;
  // Shift by half the baseline, so that the board is as far off-centre in the left image as in the
  // right.
  const Eigen::Vector3d aside(0.5 * rig.baseline_m, 0.0, 0.0);
  const Eigen::Quaterniond left_from_board =
      ExpSo3(Eigen::Vector3d(placement.tilt_x_deg * rad, 0.0, 0.0)) *
      ExpSo3(Eigen::Vector3d(0.0, placement.tilt_y_deg * rad, 0.0)) *
      ExpSo3(Eigen::Vector3d(0.0, 0.0, placement.roll_deg * rad));
  return {RigidTransform(left_from_board, board_in_left + aside).Inverse(), {}};
}

}  // namespace

CalibrationTarget MakeCalibrationTarget(const StereoCamera& rig) {
  CalibrationTarget target;
  World& world = target.world;
  world.name = "calibration_target";
  world.rig = rig;
  world.meshes = {BoardMesh()};
  world.textures = {PatternTexture()};
  Drawable board;
  board.casts_shadow = false;
  world.drawables = {board};
  world.light.directional = 0.0;
  world.light.ambient = 1.0;
  world.light.sky_rgb = {0.5, 0.5, 0.5};
  for (int row = 1; row < kRows; ++row) {
    for (int column = 1; column < kColumns; ++column) {
      target.corners_m.emplace_back(CornerX(column), CornerY(row), 0.0);
    }
  }
  for (const Placement& placement : kPlacements) target.views.push_back(Place(rig, placement));
  return target;
}

}  // namespace cvo::synth
