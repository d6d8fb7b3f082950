// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "synth/models/model.h"
#include "synth/models/textures/texture.h"

namespace cvo::synth {

// Pose of a piece that is added to a mesh, and scale and offset of the texture on it. Surfaces of
// solids are described as seen from outside: u to the right, v downwards.
struct Pen {
  Eigen::Vector2d texture_size_m = Eigen::Vector2d::Ones();
  Eigen::Vector2d uv_offset = Eigen::Vector2d::Zero();  // in repetitions of the texture
  RigidTransform model_from_piece;
  double largest_cell_m = std::numeric_limits<double>::infinity();  // largest side of a quad
};

// Returns a pen that starts at a random place of the texture.
Pen PenFor(const Texture& texture, Rng& look);

// Return a part with an empty mesh. Shell parts cast no shadow.
Part MakePart(const Texture& texture);
Part MakeShellPart(const Texture& texture);

struct Rectangle {
  Eigen::Vector3d corner;  // upper left
  Eigen::Vector3d right;   // the whole edge, as is `down`
  Eigen::Vector3d down;
};

// AddRectangle maps uv in metres from the upper left corner; AddPicture shows the whole texture
// once.
void AddRectangle(Mesh& mesh, const Pen& pen, const Rectangle& rectangle);
void AddPicture(Mesh& mesh, const Pen& pen, const Rectangle& rectangle);
// Adds a convex polygon in a horizontal plane. Its uv follow from x and y, so that overlapping
// polygons look the same.
void AddGround(Mesh& mesh, const Pen& pen, const std::vector<Eigen::Vector3d>& corners);
// Adds a box. Each face shows a different part of the texture.
void AddBox(Mesh& mesh, const Pen& pen, const Eigen::Vector3d& low, const Eigen::Vector3d& high);
// Returns a face of that box, 0 ... 5: +x, -x, +y, -y, +z, -z.
Rectangle BoxFace(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int face);
// An upright cylinder around the z axis of the piece, from z = 0. It tapers to top_radius_m.
struct Cylinder {
  double radius_m;
  double top_radius_m;
  double height_m;
  int segments = 16;
};
void AddCylinder(Mesh& mesh, const Pen& pen, const Cylinder& cylinder);
// Adds both ends of that cylinder, each with the inscribed circle of the texture.
void AddCylinderEnds(Mesh& mesh, const Pen& pen, const Cylinder& cylinder);
// A grid of points, rows x columns. AddLattice adds it with smooth normals, and uv from the lengths
// along its lines.
struct Lattice {
  int rows;
  int columns;
  std::vector<Eigen::Vector3d> points;  // row by row
};
void AddLattice(Mesh& mesh, const Pen& pen, const Lattice& lattice);
// Adds a sphere around the origin of the piece: a cube with cells x cells quads per face, projected
// onto the sphere, with uv for MakeBallTexture.
void AddBall(Mesh& mesh, const Pen& pen, double radius_m, int cells);
// Adds an ellipsoid whose surface is displaced in and out by up to `roughness` (a fraction of the
// radius), in facets with box-mapped uv.
void AddBlob(Mesh& mesh, const Pen& pen, const Eigen::Vector3d& radii_m, double roughness,
             Rng& rng);

// Returns the uv of a point projected along the largest component of its normal.
Eigen::Vector2d BoxMapping(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

// Scales the model so that its box is exactly `size_m`, and moves the centre of the box to the
// origin. Boxes among the collision shapes must be axis-aligned.
void FitTo(Model& model, const Eigen::Vector3d& size_m);
CollisionShape MakeBoxShape(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

}  // namespace cvo::synth
