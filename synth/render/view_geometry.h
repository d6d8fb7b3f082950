// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "synth/scene/world.h"

namespace cvo::synth {

// Clip coordinates (x, y, z, w) for a framebuffer whose row 0 is the top row of the image. As pixel
// centres are at integer (u, v), the window coordinates of a pixel are (u + 0.5, v + 0.5). Depth is
// kNear_m / z: 1 at the near plane and 0 at infinity, which keeps float depth precise far away.
inline constexpr double kNear_m = 0.05;
Eigen::Matrix4d ClipFromLeft(const StereoCamera& rig);
// For the right camera with its calibration error, from the left camera's frame.
Eigen::Matrix4d ClipFromRight(const StereoCamera& rig, const RigError& error);

// Orthographic projection along the light, centred on the camera. Depth increases towards the
// light. It moves in whole texels of a map with side `side_px`, so that shadow edges stay still
// when the camera moves.
Eigen::Matrix4d ShadowClipFromWorld(const Light& light, const Eigen::Vector3d& camera_in_world,
                                    int side_px);

struct Sphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

// Returns a sphere that contains all vertices, centred on their bounding box.
Sphere BoundingSphere(const Mesh& mesh);

// Returns false only if the sphere, given in the body's frame, is entirely outside the clip volume.
bool MayBeVisible(const Eigen::Matrix4d& clip_from_body, const Sphere& sphere);

}  // namespace cvo::synth
