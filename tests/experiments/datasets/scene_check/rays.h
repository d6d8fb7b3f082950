// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo::test {

// A wall, a floor, a rolling ball and a box at rest, drawn by ray casting: a scene that shares no
// code with the program's renderer. The world frame is that of the first left camera.
class RayScene {
 public:
  static constexpr int kFrames = 4;
  static constexpr double kRate_hz = 10.0;
  static constexpr int kBodies = 2;
  static constexpr double kBallRadius_m = 0.35;

  RayScene();

  // What the ray from a camera through a pixel hits; body 0 is the background.
  struct Hit {
    double depth_m = 0.0;
    int body = 0;
    double grey = 0.0;
  };
  Hit Cast(const RigidTransform& world_from_camera, double u, double v, int frame) const;

  const StereoCamera& camera() const { return camera_; }
  RigidTransform WorldFromLeft(int frame) const;
  RigidTransform WorldFromRight(int frame) const;
  RigidTransform WorldFromObject(int body, int frame) const;
  Eigen::Vector3d Velocity(int body) const;
  Eigen::Vector3d AngularVelocity(int body) const;
  Eigen::Vector3d Size_m(int body) const;

 private:
  double Texture(const Eigen::Vector3d& p, int body) const;

  StereoCamera camera_;
  Eigen::Matrix<double, 3, 12> waves_;
  Eigen::Matrix<double, 12, 1> phases_;
};

// Writes a whole scene folder as the renderer does: noisy images, ground truth and manifest.
void WriteRayScene(const std::filesystem::path& folder);

}  // namespace cvo::test
