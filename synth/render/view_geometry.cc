// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
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

// In place of renderer.cc in a build without OSMesa. Everything else builds and works.
#if !defined(CVO_WITH_OSMESA)
namespace {

[[noreturn]] void ThrowMissing() {
  ThrowError("synthetic scenes", "no OSMesa in this build",
             "libosmesa6-dev installed and -DCVO_OSMESA=ON when configuring");
}

}  // namespace

struct Renderer::State {};

Renderer::Renderer(const World&) { ThrowMissing(); }
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Rendering Renderer::Draw(const View&) { ThrowMissing(); }
void Renderer::DrawImages(const View&, cv::Mat&, cv::Mat&) { ThrowMissing(); }
RendererVersion FindRendererVersion() { ThrowMissing(); }
#endif

}  // namespace cvo::synth
