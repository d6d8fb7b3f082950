// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "synth/models/model.h"
#include "synth/motion/motion.h"

namespace cvo::synth {

// One draw call: a mesh with one texture.
struct Drawable {
  int mesh = 0;     // into World::meshes
  int texture = 0;  // into World::textures
  int body = 0;     // 0: static background, in world; else Body::id, drawn at world_from_body
  float gloss = 0;  // strength of the highlight of the directional light, 0 ... 1
  bool casts_shadow = true;
};

// An object of a class that a detector knows, moving or not. Body frame: x forward, y left, z up,
// origin at the centre of its box.
struct Body {
  int id = 0;            // 1, 2, ... in the order of World::bodies; the value in instance masks
  std::string name;      // "ball_1"
  std::string category;  // "Ball", "Chair", "Block", "Car", ...: the type in labels
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // of the box along x, y, z
  std::shared_ptr<const Motion> motion;
};

struct Light {
  Eigen::Vector3d direction = {0.3, 0.2, -1.0};  // of travel of the directional light, in world
  double directional = 0.65;                     // irradiance of a surface facing it
  double ambient = 0.62;                         // from all directions, a third less from below
  Eigen::Vector3d sky_rgb = {0.75, 0.82, 0.9};   // colour where there is no surface
  double shadow_range_m = 8.0;                   // shadows are drawn this far around the camera
};

// Difference between the true right camera and the one that the rig describes: a calibration error
// that calib.txt does not contain. All zero: no error.
struct RigError {
  double shift_px = 0.0;                    // of the principal point, to the right
  std::array<double, 3> rotation_deg = {};  // about its x, y, z axes
  double focal = 0.0;                       // relative error of the focal length

  bool operator==(const RigError&) const = default;
  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("shift_px", self.shift_px);
    archive.Field("rotation_deg", self.rotation_deg);
    archive.Field("focal", self.focal);
  }
};

// A built scene: everything that the renderer and the ground truth need. Camera frames are those of
// StereoCamera (x right, y down, z forward); `camera` is the motion of the left camera.
struct World {
  std::string name;
  StereoCamera rig;
  RigError rig_error;
  int frames = 0;
  double rate_hz = 0.0;
  std::vector<Mesh> meshes;
  std::vector<cv::Mat> textures;  // CV_8UC3, RGB, sides are powers of two
  std::vector<Drawable> drawables;
  std::vector<Body> bodies;
  std::shared_ptr<const Motion> camera;
  Light light;

  double Time_s(int frame) const { return frame / rate_hz; }
};

// Returns the separation of two convex shapes, m. It never exceeds their distance and is positive
// if they are disjoint. If they overlap, it is the negative length of the smallest translation that
// separates them.
double Separation(const CollisionShape& a, const RigidTransform& world_from_a,
                  const CollisionShape& b, const RigidTransform& world_from_b);

// Signed distance, m, from the plane n . p + d = 0 with unit n to the lowest point of a shape along
// n.
double PlaneSeparation(const CollisionShape& shape, const RigidTransform& world_from_model,
                       const Eigen::Vector4d& plane);

// Radius, m, of a sphere around the origin of the model that contains all shapes.
double BoundingRadius_m(const std::vector<CollisionShape>& shapes);

// A solid object that other solids must not penetrate.
struct Solid {
  std::string name;
  std::vector<CollisionShape> shapes;
  std::shared_ptr<const Motion> motion;  // null: static; static solids may overlap each other
  RigidTransform world_from_model;       // pose if `motion` is null
};

// Checks from time zero to `duration_s` that no solid penetrates another and that no moving solid
// crosses a wall (planes with inward normals). Touching is allowed. Throws Error at `where` that
// names the first collision. The result does not depend on the number of threads.
void CheckCollisions(const std::vector<Solid>& solids, const std::vector<Eigen::Vector4d>& walls,
                     double duration_s, int threads, const std::string& where);

// Throws Error for a body whose bounding sphere is outside the left camera's view in every frame.
void CheckInView(const World& world, const std::string& where);

}  // namespace cvo::synth
