// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/truth/flow.h"

#include <cmath>

#include "core/base/error.h"

namespace cvo::synth {
namespace {

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

}  // namespace

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

}  // namespace cvo::synth
