// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small worlds and scene files for the tests of synthetic scenes.

#include <cmath>
#include <memory>
#include <string>

#include "core/base/rng.h"
#include "core/files/json/json.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

// Translation at constant velocity, without rotation, from a pose at time 0.
class StraightMotion : public Motion {
 public:
  explicit StraightMotion(const RigidTransform& start,
                          const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero())
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
  world.camera = std::make_shared<StraightMotion>(LookingAlongX());
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
  body.motion = std::make_shared<StraightMotion>(
      RigidTransform(Eigen::Quaterniond::Identity(), body_in_world));
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
  world.camera = std::make_shared<StraightMotion>(LookingAlongX());
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

// A valid scene without objects, for tests to modify. The camera moves along x and looks along its
// route.
inline Json EmptyScene() {
  return ParseJson(R"({
    "name": "empty", "rig": {"width_px": 640, "height_px": 480, "focal_px": 450, "baseline_m": 0.12},
    "frames": 30, "rate_hz": 30,
    "room": {"size_m": [8, 8, 2.6], "shelves": 0, "tables": 0, "crates": 0, "posters": 0},
    "camera": {"route": {"points": [[-3, 0], [3, 0]], "speed_mps": 0.5}, "height_m": 1.2,
               "look_along": {}},
    "objects": []
  })",
                   "EmptyScene");
}

inline Json BallObject(const std::string& name, const std::string& path) {
  return {{"name", name}, {"model", "ball"}, {"size_m", 0.5}, {"path", ParseJson(path, name)}};
}

}  // namespace cvo::synth
