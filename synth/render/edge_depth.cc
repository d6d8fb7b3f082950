// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/edge_depth.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cvo::synth {
namespace {

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

}  // namespace cvo::synth
