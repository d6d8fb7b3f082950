// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"
#include "synth/models/model.h"

namespace cvo::synth {

struct Texture {
  cv::Mat image;                                     // CV_8UC3, RGB, sides are powers of two
  Eigen::Vector2d size_m = Eigen::Vector2d::Ones();  // of one repetition along u and v
};

// Makes one of MaterialNames() (synth/models/make_model.h). Throws Error for an unknown name.
Texture MakeTexture(const std::string& material, Rng& look);

// Makes six square views from the centre of a ball, in a grid of 4 x 2 and in the face order of
// AddBall.
Texture MakeBallTexture(Rng& look);
// Fraction of the side of a tile that its face covers. The pattern continues beyond the face for
// the sake of mipmaps.
constexpr double kBallTileFill = 0.9;

// Textures of small things, one picture each.
Texture MakeSolidTexture(const cv::Vec3f& rgb, Rng& look);
Texture MakeWindowViewTexture(Rng& look);
Texture MakeDoorTexture(Rng& look);
Texture MakeCarGlassTexture(Rng& look);
Texture MakeWheelTexture(Rng& look);
Texture MakePlateTexture(Rng& look);
// Spines of books in a grid of kBookColumns x kBookRows.
Texture MakeBooksTexture(Rng& look);
constexpr int kBookColumns = 16;
constexpr int kBookRows = 2;

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

// Scales the model so that its box is exactly `size_m`, and moves the centre of the box to the
// origin. Boxes among the collision shapes must be axis-aligned.
void FitTo(Model& model, const Eigen::Vector3d& size_m);
CollisionShape MakeBoxShape(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

// Direction of the point (a, b) in [-1, 1]^2 on a face of a cube (0 ... 5: +x, -x, +y, -y, +z, -z),
// warped so that equal steps of a and b are nearly equal angles.
inline Eigen::Vector3d CubeDirection(int face, double a, double b) {
  const double u = a * (0.7 + 0.3 * a * a);
  const double v = b * (0.7 + 0.3 * b * b);
  const double side = face % 2 == 0 ? 1.0 : -1.0;
  const int axis = face / 2;
  Eigen::Vector3d direction;
  direction[axis] = side;
  direction[(axis + 1) % 3] = side * u;
  direction[(axis + 2) % 3] = v;
  return direction.normalized();
}

// Each builder makes one kind of model, with z from 0 and about the requested size, which MakeModel
// then fits exactly.
Model BuildBall(const ModelDescription& request, Rng& look);
Model BuildBlock(const ModelDescription& request, Rng& look);
Model BuildTower(const ModelDescription& request, Rng& look);
Model BuildCrate(const ModelDescription& request, Rng& look);
Model BuildChair(const ModelDescription& request, Rng& look);
Model BuildTable(const ModelDescription& request, Rng& look);
Model BuildShelf(const ModelDescription& request, Rng& look);
Model BuildCar(const ModelDescription& request, Rng& look);
Model BuildTree(const ModelDescription& request, Rng& look);
Model BuildBuilding(const ModelDescription& request, Rng& look);

// These models take textures that several of them share. They have exactly the given size, and the
// origin at their centre.
Model MakeTree(const Eigen::Vector3d& size_m, const Texture& leaves, const Texture& bark,
               Rng& look);
Model MakeBuilding(const Eigen::Vector3d& size_m, const Texture& facade, const Texture& roof,
                   Rng& look);
Model MakeHedge(const Eigen::Vector3d& size_m, const Texture& leaves, Rng& look);
Model MakeLampPost(double height_m, const Texture& metal, const Texture& lamp);
Model MakeSign(const Texture& picture, const Texture& metal, Rng& look);

// Makes the requested material, or `usual` if the request has none.
Texture MaterialOr(const ModelDescription& request, const std::string& usual, Rng& look);

// Returns the polyline with corners rounded by arcs of radius `radius_m` (less if the legs are
// short), in steps of about `step_m`. Throws Error for fewer than two points and for coincident
// points.
std::vector<Eigen::Vector2d> RoundedPolyline(const std::vector<Eigen::Vector2d>& points,
                                             double radius_m, double step_m = 1.0);

double DistanceToPolyline(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& point);

// Returns the unit tangent of the line at each of its points.
std::vector<Eigen::Vector2d> TangentsOf(const std::vector<Eigen::Vector2d>& line);

// The geometry of a road. Its centre line is in steps of about a metre.
struct Road {
  std::vector<Eigen::Vector2d> line;
  std::vector<Eigen::Vector2d> tangents;
  double half_width_m = 0.0;
};

// A rotated rectangle on the ground.
struct Plot {
  Eigen::Vector2d middle;
  Eigen::Vector2d forward;  // unit length
  Eigen::Vector2d half_m;   // half sizes along `forward` and to its left
};

bool Overlap(const Plot& a, const Plot& b);

// The roads and the occupied plots.
struct StreetMap {
  std::vector<Road> roads;
  double pavement_m = 0.0;
  std::vector<Plot> plots;

  // Whether the point is within `margin_m` of the carriageway of any road except `own` (-1: any
  // road).
  bool IsOnRoad(const Eigen::Vector2d& point, double margin_m, int own) const;
  // Whether the plot is at least `margin_m` from all roads and overlaps no occupied plot.
  bool IsFree(const Plot& plot, double margin_m) const;
};

StreetMap MakeStreetMap(const StreetDescription& street);

}  // namespace cvo::synth
