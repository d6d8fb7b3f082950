// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <optional>

#include "core/base/error.h"
#include "synth/render/renderer.h"

namespace cvo::synth {
namespace {

// How far beyond the shadow range, along the light, an object still casts its shadow.
constexpr double kShadowDepth_m = 60.0;

Eigen::Matrix4d ClipFromCamera(const StereoCamera& rig, double cx) {
  const double width = rig.width_px;
  const double height = rig.height_px;
  Eigen::Matrix4d clip_from_camera;
  clip_from_camera << 2.0 * rig.fx / width, 0.0, (2.0 * cx + 1.0) / width - 1.0, 0.0,  //
      0.0, 2.0 * rig.fy / height, (2.0 * rig.cy + 1.0) / height - 1.0, 0.0,            //
      0.0, 0.0, 0.0, kNear_m,                                                          //
      0.0, 0.0, 1.0, 0.0;
  return clip_from_camera;
}

// Greater than the error of rounding depth to 32 bits, but small enough not to matter.
constexpr double kTolerance_m = 0.003;

// The box of a body relative to the left camera.
struct BodyBox {
  RigidTransform body_from_left;
  Eigen::Vector3d half_size_m;
  double middle_z_m = 0.0;
};

std::optional<BodyBox> SeeBox(const Body& body, const View& view) {
  if (!(body.size_m.minCoeff() > 0.0)) return std::nullopt;
  const RigidTransform& world_from_body =
      view.world_from_body[static_cast<std::size_t>(body.id) - 1];
  const RigidTransform left_from_body = view.world_from_left.Inverse() * world_from_body;
  return BodyBox{left_from_body.Inverse(), 0.5 * body.size_m, left_from_body.translation().z()};
}

bool IsInside(const StereoCamera& rig, const BodyBox& box, int u, int v, double z_m) {
  const Eigen::Vector3d p_in_left((u - rig.cx) * z_m / rig.fx, (v - rig.cy) * z_m / rig.fy, z_m);
  const Eigen::Vector3d p_in_body = box.body_from_left * p_in_left;
  const Eigen::Vector3d bound =
      (box.half_size_m.array() + kTolerance_m * (1.0 + 0.1 * z_m)).matrix();
  return (p_in_body.cwiseAbs() - bound).maxCoeff() <= 0.0;
}

// Uses the depth as drawn, not as corrected so far, so that the order of pixels does not matter.
float DepthOfNeighbour(const cv::Mat& drawn, const cv::Mat& instances, int u, int v,
                       double middle_z_m) {
  float best = drawn.at<float>(v, u);
  for (int y = std::max(0, v - 1); y <= std::min(drawn.rows - 1, v + 1); ++y) {
    for (int x = std::max(0, u - 1); x <= std::min(drawn.cols - 1, u + 1); ++x) {
      if (instances.at<std::uint16_t>(y, x) != instances.at<std::uint16_t>(v, u)) continue;
      const float z_m = drawn.at<float>(y, x);
      if (std::abs(z_m - middle_z_m) < std::abs(best - middle_z_m)) best = z_m;
    }
  }
  return best;
}

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

Eigen::Matrix4d ClipFromLeft(const StereoCamera& rig) { return ClipFromCamera(rig, rig.cx); }

Eigen::Matrix4d ClipFromRight(const StereoCamera& rig, const RigError& error) {
  StereoCamera right = rig;
  right.fx *= 1.0 + error.focal;
  right.fy *= 1.0 + error.focal;
  const RigidTransform left_from_right(
      ExpSo3(Eigen::Vector3d(error.rotation_deg.data()) * std::numbers::pi / 180.0),
      Eigen::Vector3d(rig.baseline_m, 0.0, 0.0));
  return ClipFromCamera(right, rig.cx + rig.right_shift_px + error.shift_px) *
         left_from_right.Inverse().Matrix();
}

Eigen::Matrix4d ShadowClipFromWorld(const Light& light, const Eigen::Vector3d& camera_in_world,
                                    int side_px) {
  const Eigen::Vector3d to_light = -light.direction.normalized();
  const Eigen::Vector3d x_axis = to_light.unitOrthogonal();
  const Eigen::Vector3d y_axis = to_light.cross(x_axis);
  const double range = light.shadow_range_m;
  const double texel = 2.0 * range / side_px;
  const auto snapped = [&](const Eigen::Vector3d& axis) {
    return std::round(axis.dot(camera_in_world) / texel) * texel;
  };
  const double depth_range = range + kShadowDepth_m;
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip.row(0) << x_axis.transpose() / range, -snapped(x_axis) / range;
  clip.row(1) << y_axis.transpose() / range, -snapped(y_axis) / range;
  clip.row(2) << to_light.transpose() / (2.0 * depth_range),
      0.5 - to_light.dot(camera_in_world) / (2.0 * depth_range);
  clip(3, 3) = 1.0;
  return clip;
}

Sphere BoundingSphere(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vertex& vertex : mesh.vertices) box.extend(vertex.position.cast<double>());
  if (box.isEmpty()) return {};
  Sphere sphere;
  sphere.centre = box.center();
  for (const Vertex& vertex : mesh.vertices) {
    const double distance = (vertex.position.cast<double>() - sphere.centre).norm();
    sphere.radius = std::max(sphere.radius, distance);
  }
  return sphere;
}

bool MayBeVisible(const Eigen::Matrix4d& clip_from_body, const Sphere& sphere) {
  const auto is_outside = [&](const Eigen::RowVector4d& plane) {
    const double distance = plane.head<3>().dot(sphere.centre) + plane[3];
    return distance < -sphere.radius * plane.head<3>().norm();
  };
  const Eigen::RowVector4d w = clip_from_body.row(3);
  const auto row = [&](int i) -> Eigen::RowVector4d { return clip_from_body.row(i); };
  return !is_outside(w + row(0)) && !is_outside(w - row(0)) && !is_outside(w + row(1)) &&
         !is_outside(w - row(1)) && !is_outside(w - row(2));
}

void CorrectEdgeDepth(const StereoCamera& rig, const std::vector<Body>& bodies, const View& view,
                      Rendering& rendering) {
  std::vector<std::optional<BodyBox>> boxes;
  for (const Body& body : bodies) boxes.push_back(SeeBox(body, view));
  const cv::Mat drawn = rendering.depth.clone();
  for (int v = 0; v < drawn.rows; ++v) {
    const auto* ids = rendering.instances.ptr<std::uint16_t>(v);
    for (int u = 0; u < drawn.cols; ++u) {
      if (ids[u] == 0 || !boxes[ids[u] - 1U]) continue;
      const BodyBox& box = *boxes[ids[u] - 1U];
      if (IsInside(rig, box, u, v, drawn.at<float>(v, u))) continue;
      rendering.depth.at<float>(v, u) =
          DepthOfNeighbour(drawn, rendering.instances, u, v, box.middle_z_m);
    }
  }
}

cv::Mat LumaOf(const cv::Mat& image) {
  Require(image.type() == CV_8UC4, "an image of the renderer has four channels");
  cv::Mat luma;
  cv::extractChannel(image, luma, 3);
  return luma;
}

cv::Mat ColourOf(const cv::Mat& image) {
  Require(image.type() == CV_8UC4, "an image of the renderer has four channels");
  cv::Mat colour(image.size(), CV_8UC3);
  cv::mixChannels({image}, {colour}, {0, 2, 1, 1, 2, 0});
  return colour;
}

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

// In place of renderer.cc in a build without OSMesa. Everything else builds and works.
#if !defined(CVO_WITH_OSMESA)
namespace {

[[noreturn]] void ThrowMissing() {
  ThrowError("synthetic scenes", "no OSMesa in this build",
             "libosmesa6-dev installed and -DCVO_OSMESA=ON when configuring");
}

}  // namespace

struct Renderer::State {};

Renderer::Renderer(const World&, int) { ThrowMissing(); }
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Rendering Renderer::Draw(const View&) { ThrowMissing(); }
void Renderer::DrawImages(const View&, cv::Mat&, cv::Mat&) { ThrowMissing(); }
RendererVersion FindRendererVersion() { ThrowMissing(); }
#endif

}  // namespace cvo::synth
