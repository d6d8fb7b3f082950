// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "synth/scene/world.h"

namespace cvo::synth {

// Clip coordinates (x, y, z, w) for a frame buffer whose row 0 is the image's top row: the window
// coordinate of a pixel is (u + 0.5, v + 0.5), as pixel centres are at integers in (u, v). Depth is
// kNear_m / z: 1 at the near plane, 0 at infinity, so that float depth is precise far away.
inline constexpr double kNear_m = 0.05;
Eigen::Matrix4d ClipFromLeft(const StereoCamera& rig);
// Of the right camera as it really is, from the left camera's frame.
Eigen::Matrix4d ClipFromRight(const StereoCamera& rig, const RigError& error);

// Parallel projection along the light around the camera, depth greater towards the light. Moves in
// whole texels of a map with `side_px`, so that edges of shadows stay still when the camera moves.
Eigen::Matrix4d ShadowClipFromWorld(const Light& light, const Eigen::Vector3d& camera_in_world,
                                    int side_px);

struct Sphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

// Around the box of the vertices.
Sphere BoundingSphere(const Mesh& mesh);

// False where nothing of the sphere, given in the body's frame, can be within the clip volume.
bool MayBeVisible(const Eigen::Matrix4d& clip_from_body, const Sphere& sphere);

}  // namespace cvo::synth
