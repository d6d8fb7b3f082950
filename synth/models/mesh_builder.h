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

// Where pieces go in a mesh and how large the texture is on them. Pieces outside of solids have
// their outlines seen from outside: u to the right, v downwards.
struct Pen {
  Eigen::Vector2d texture_size_m = Eigen::Vector2d::Ones();
  Eigen::Vector2d uv_offset = Eigen::Vector2d::Zero();  // in repetitions
  RigidTransform model_from_piece;
  double largest_cell_m = std::numeric_limits<double>::infinity();  // of quads
};

// Starts at a random place of the texture.
Pen PenFor(const Texture& texture, Rng& look);

// A part whose mesh is still empty; one of a shell casts no shadow.
Part MakePart(const Texture& texture);
Part MakeShellPart(const Texture& texture);

struct Rectangle {
  Eigen::Vector3d corner;  // upper left
  Eigen::Vector3d right;   // whole edges
  Eigen::Vector3d down;
};

// uv in metres from the upper left corner, or (Picture) the whole texture once.
void AddRectangle(Mesh& mesh, const Pen& pen, const Rectangle& rectangle);
void AddPicture(Mesh& mesh, const Pen& pen, const Rectangle& rectangle);
// On a horizontal plane, uv from x and y: pieces that overlap look the same.
void AddGround(Mesh& mesh, const Pen& pen, const std::vector<Eigen::Vector3d>& corners);
// Each face shows another cut of the texture.
void AddBox(Mesh& mesh, const Pen& pen, const Eigen::Vector3d& low, const Eigen::Vector3d& high);
// The side faces of that box: +x, -x, +y, -y, +z, -z.
Rectangle BoxFace(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int face);
// Upright, around the z axis of the piece, from z = 0; tapers to top_radius.
struct Cylinder {
  double radius_m;
  double top_radius_m;
  double height_m;
  int segments = 16;
};
void AddCylinder(Mesh& mesh, const Pen& pen, const Cylinder& cylinder);
// The unit circle's picture on both ends of that cylinder.
void AddCylinderEnds(Mesh& mesh, const Pen& pen, const Cylinder& cylinder);
// A grid of points, rows x columns, with smooth normals; uv by the lengths along its lines.
struct Lattice {
  int rows;
  int columns;
  std::vector<Eigen::Vector3d> points;  // row by row
};
void AddLattice(Mesh& mesh, const Pen& pen, const Lattice& lattice);
// A sphere around the piece's origin from a cube of cells x cells faces, with the uv of
// MakeBallTexture.
void AddBall(Mesh& mesh, const Pen& pen, double radius_m, int cells);
// As a ball, its surface pushed in and out by up to `roughness` (part of the radius), flat facets
// with box-mapped uv.
void AddBlob(Mesh& mesh, const Pen& pen, const Eigen::Vector3d& radii_m, double roughness,
             Rng& rng);

// uv of points seen along the largest component of their normal.
Eigen::Vector2d BoxMapping(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

// Stretches the model so that its box has `size_m` exactly, and moves the box's middle to the
// origin. Boxes among the shapes must not be turned.
void FitTo(Model& model, const Eigen::Vector3d& size_m);
CollisionShape MakeBoxShape(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

}  // namespace cvo::synth
