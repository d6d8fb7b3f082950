// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>

#include "core/base/rng.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

inline StereoCamera SmallRig() {
  StereoCamera rig;
  rig.fx = 150.0;
  rig.fy = 155.0;
  rig.cx = 78.3;
  rig.cy = 61.8;
  rig.baseline_m = 0.2;
  rig.width_px = 160;
  rig.height_px = 120;
  return rig;
}

// A camera at the origin that looks along world x, with z up: camera x is -y, camera y is -z.
inline RigidTransform LookingAlongX() {
  Eigen::Matrix3d world_from_camera;
  world_from_camera << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {world_from_camera, Eigen::Vector3d::Zero()};
}

class Standing final : public Motion {
 public:
  explicit Standing(const RigidTransform& world_from_body) {
    state_.world_from_body = world_from_body;
  }
  MotionState At(double) const override { return state_; }

 private:
  MotionState state_;
};

inline cv::Mat NoiseTexture(int side_px) {
  Rng rng(1, "texture");
  cv::Mat texture(side_px, side_px, CV_8UC3);
  for (int row = 0; row < side_px; ++row) {
    for (int column = 0; column < side_px; ++column) {
      texture.at<cv::Vec3b>(row, column) =
          cv::Vec3b::all(static_cast<uchar>(60 + rng.UniformInt(140)));
    }
  }
  return texture;
}

// A parallelogram; its normal is u x v.
inline Mesh Quad(const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                 const Eigen::Vector3d& v) {
  Mesh mesh;
  const Eigen::Vector3f normal = u.cross(v).normalized().cast<float>();
  for (const Eigen::Vector2f& uv : {Eigen::Vector2f(0, 0), Eigen::Vector2f(1, 0),
                                    Eigen::Vector2f(0, 1), Eigen::Vector2f(1, 1)}) {
    const Eigen::Vector3d at = corner + uv.x() * u + uv.y() * v;
    mesh.vertices.push_back({at.cast<float>(), normal, uv});
  }
  mesh.indices = {0, 1, 2, 1, 3, 2};
  return mesh;
}

// A sphere with facets smaller than a pixel of SmallRig() from 2 m on.
inline Mesh Ball(double radius_m) {
  constexpr std::uint32_t kSlices = 96;
  constexpr std::uint32_t kStacks = 48;
  const double pi = std::acos(-1.0);
  Mesh mesh;
  for (std::uint32_t i = 0; i <= kStacks; ++i) {
    for (std::uint32_t j = 0; j <= kSlices; ++j) {
      const double latitude = pi * (static_cast<double>(i) / kStacks - 0.5);
      const double longitude = 2.0 * pi * j / kSlices;
      const Eigen::Vector3d normal(std::cos(latitude) * std::cos(longitude),
                                   std::cos(latitude) * std::sin(longitude), std::sin(latitude));
      const Eigen::Vector2d uv(static_cast<double>(j) / kSlices, static_cast<double>(i) / kStacks);
      mesh.vertices.push_back(
          {(radius_m * normal).cast<float>(), normal.cast<float>(), uv.cast<float>()});
    }
  }
  for (std::uint32_t i = 0; i < kStacks; ++i) {
    for (std::uint32_t j = 0; j < kSlices; ++j) {
      const std::uint32_t a = i * (kSlices + 1) + j;
      const std::uint32_t b = a + kSlices + 1;
      for (std::uint32_t index : {a, a + 1, b, a + 1, b + 1, b}) mesh.indices.push_back(index);
    }
  }
  return mesh;
}

// A world with a noise texture, to which AddBackground and AddBody add meshes.
inline World EmptyWorld() {
  World world;
  world.name = "test";
  world.rig = SmallRig();
  world.textures = {NoiseTexture(64)};
  world.camera = std::make_shared<Standing>(LookingAlongX());
  return world;
}

inline void AddBackground(World& world, const Mesh& mesh) {
  Drawable drawable;
  drawable.mesh = static_cast<int>(world.meshes.size());
  world.meshes.push_back(mesh);
  world.drawables.push_back(drawable);
}

inline void AddBody(World& world, const Mesh& mesh, const Eigen::Vector3d& body_in_world) {
  Body body;
  body.id = static_cast<int>(world.bodies.size()) + 1;
  body.motion =
      std::make_shared<Standing>(RigidTransform(Eigen::Quaterniond::Identity(), body_in_world));
  world.bodies.push_back(body);
  AddBackground(world, mesh);
  world.drawables.back().body = body.id;
}

inline View ViewOf(const World& world) {
  View view;
  view.world_from_left = world.camera->At(0.0).world_from_body;
  for (const Body& body : world.bodies) {
    view.world_from_body.push_back(body.motion->At(0.0).world_from_body);
  }
  return view;
}

// A floor, a wall in front and two balls, the first partly behind the second.
inline World BallsWorld() {
  World world = EmptyWorld();
  AddBackground(world, Quad({0, -5, -0.8}, {6, 0, 0}, {0, 10, 0}));
  AddBackground(world, Quad({6, -5, -0.8}, {0, 0, 4}, {0, 10, 0}));
  AddBody(world, Ball(0.4), {3.5, 0.3, -0.2});
  AddBody(world, Ball(0.3), {2.5, 0.0, -0.4});
  return world;
}

}  // namespace cvo::synth
