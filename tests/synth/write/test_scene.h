// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "synth/render/renderer.h"
#include "synth/scene/world.h"

namespace cvo::synth::test {

// Translation at constant velocity, without rotation, from a pose at time 0.
class StraightMotion : public Motion {
 public:
  StraightMotion(const RigidTransform& start, const Eigen::Vector3d& velocity)
      : start_(start), velocity_(velocity) {}
  MotionState At(double time_s) const override {
    const Eigen::Vector3d position = start_.translation() + time_s * velocity_;
    return {RigidTransform(Eigen::Quaterniond(start_.rotation()), position), velocity_,
            Eigen::Vector3d::Zero()};
  }

 private:
  RigidTransform start_;
  Eigen::Vector3d velocity_;
};

// A camera at the world origin that looks along world x: its axes x, y and z are world -y, -z and
// x.
inline RigidTransform WorldFromForwardCamera() {
  Eigen::Matrix3d R;
  R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {R, Eigen::Vector3d::Zero()};
}

// The eight corners and twelve triangles of a box around the origin.
inline Mesh BoxMesh(const Eigen::Vector3d& size_m) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5);
    mesh.vertices.push_back({corner.cwiseProduct(size_m).cast<float>(), Eigen::Vector3f::UnitX(),
                             Eigen::Vector2f::Zero()});
  }
  mesh.indices = {0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                  2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 3, 7, 1, 7, 5};
  return mesh;
}

// 100 x 80 pixels, f = 100 px, 10 Hz, 6 frames; one body of 1 x 2 x 1.5 m, which starts 4.5 m ahead
// and moves to the left at 1 m/s.
inline World OneBoxWorld(const Eigen::Vector3d& start = {4.5, 0.0, 0.0}) {
  World world;
  world.name = "one_box";
  world.rig = {100.0, 100.0, 49.5, 39.5, 0.2, 100, 80};
  world.frames = 6;
  world.rate_hz = 10.0;
  const Eigen::Vector3d size_m(1.0, 2.0, 1.5);
  world.meshes.push_back(BoxMesh(size_m));
  world.drawables.push_back({.mesh = 0, .texture = 0, .body = 1});
  const RigidTransform pose(Eigen::Quaterniond::Identity(), start);
  world.bodies.push_back({1, "box_1", "Block", size_m,
                          std::make_shared<StraightMotion>(pose, Eigen::Vector3d::UnitY())});
  world.camera =
      std::make_shared<StraightMotion>(WorldFromForwardCamera(), Eigen::Vector3d::Zero());
  return world;
}

// Uniform images with an empty instance mask and no depth.
inline Rendering EmptyRendering(const World& world) {
  const cv::Size size(world.rig.width_px, world.rig.height_px);
  Rendering rendering;
  rendering.left = cv::Mat(size, CV_8UC4, cv::Scalar(90, 100, 110, 100));
  rendering.right = rendering.left.clone();
  rendering.depth = cv::Mat(size, CV_32FC1, cv::Scalar(0));
  rendering.instances = cv::Mat(size, CV_16UC1, cv::Scalar(0));
  rendering.alone_px.assign(world.bodies.size(), 0);
  return rendering;
}

}  // namespace cvo::synth::test
