// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "synth/models/build.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::uint32_t AddVertex(Mesh& mesh, const Pen& pen, const Vector3d& point, const Vector3d& normal,
                        const Vector2d& uv) {
  mesh.vertices.push_back({(pen.model_from_piece * point).cast<float>(),
                           (pen.model_from_piece.rotation() * normal).normalized().cast<float>(),
                           uv.cast<float>()});
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

Vector2d InMetres(const Pen& pen, const Vector2d& uv_m) {
  return uv_m.cwiseQuotient(pen.texture_size_m) + pen.uv_offset;
}

// Returns the uv of a point projected along the largest component of its normal.
Vector2d BoxMapping(const Vector3d& point, const Vector3d& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  if (axis == 0) return {point.y(), -point.z()};
  if (axis == 1) return {point.x(), -point.z()};
  return {point.x(), -point.y()};
}

void AddGridIndices(Mesh& mesh, std::uint32_t first, int rows, int columns) {
  for (int r = 0; r + 1 < rows; ++r) {
    for (int c = 0; c + 1 < columns; ++c) {
      const std::uint32_t a = first + static_cast<std::uint32_t>(r * columns + c);
      const std::uint32_t b = a + static_cast<std::uint32_t>(columns);
      for (const std::uint32_t index : {a, b, a + 1, a + 1, b, b + 1}) {
        mesh.indices.push_back(index);
      }
    }
  }
}

// Adds a rectangle as a grid of quads. uv(s, t) is called with s along `right` and t along `down`,
// both in [0, 1].
template <typename Uv>
void AddCells(Mesh& mesh, const Pen& pen, const Rectangle& rectangle, Uv uv) {
  const Vector3d normal = rectangle.down.cross(rectangle.right).normalized();
  const int columns = 1 + static_cast<int>(std::ceil(rectangle.right.norm() / pen.largest_cell_m));
  const int rows = 1 + static_cast<int>(std::ceil(rectangle.down.norm() / pen.largest_cell_m));
  const int across = std::max(2, columns);
  const int along = std::max(2, rows);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int r = 0; r < along; ++r) {
    for (int c = 0; c < across; ++c) {
      const double s = static_cast<double>(c) / (across - 1);
      const double t = static_cast<double>(r) / (along - 1);
      AddVertex(mesh, pen, rectangle.corner + s * rectangle.right + t * rectangle.down, normal,
                uv(s, t));
    }
  }
  AddGridIndices(mesh, first, along, across);
}

}  // namespace

void AddRectangle(Mesh& mesh, const Pen& pen, const Rectangle& rectangle) {
  const Vector2d edges(rectangle.right.norm(), rectangle.down.norm());
  AddCells(mesh, pen, rectangle,
           [&](double s, double t) { return InMetres(pen, edges.cwiseProduct(Vector2d(s, t))); });
}

void AddPicture(Mesh& mesh, const Pen& pen, const Rectangle& rectangle) {
  AddCells(mesh, pen, rectangle, [](double s, double t) { return Vector2d(s, t); });
}

void AddGround(Mesh& mesh, const Pen& pen, const std::vector<Vector3d>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3d& p : corners) {
    AddVertex(mesh, pen, p, Vector3d::UnitZ(), InMetres(pen, {p.x(), -p.y()}));
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i) {
    for (const std::uint32_t index : {first, first + i - 1, first + i}) {
      mesh.indices.push_back(index);
    }
  }
}

Rectangle BoxFace(const Vector3d& low, const Vector3d& high, int face) {
  const Vector3d size = high - low;
  const Vector3d x(size.x(), 0, 0);
  const Vector3d y(0, size.y(), 0);
  const Vector3d z(0, 0, size.z());
  switch (face) {
    case 0:
      return {low + x + z, y, -z};
    case 1:
      return {high - x, -y, -z};
    case 2:
      return {high, -x, -z};
    case 3:
      return {low + z, x, -z};
    case 4:
      return {high - x, x, -y};
    default:
      return {low, x, y};
  }
}

void AddBox(Mesh& mesh, const Pen& pen, const Vector3d& low, const Vector3d& high) {
  const Vector2d start(0.73 * low.x() + 0.31 * low.z(), 0.57 * low.y() + 0.83 * low.z());
  for (int face = 0; face < 6; ++face) {
    Pen shifted = pen;
    shifted.uv_offset += Vector2d(0.37 * face, 0.61 * face) + start;
    AddRectangle(mesh, shifted, BoxFace(low, high, face));
  }
}

void AddCylinder(Mesh& mesh, const Pen& pen, const Cylinder& cylinder) {
  // A whole number of repetitions around, or the seam would show.
  const double around = 2.0 * 3.14159265358979 * cylinder.radius_m;
  const double repetitions = std::max(1.0, std::round(around / pen.texture_size_m.x()));
  const double slope = (cylinder.radius_m - cylinder.top_radius_m) / cylinder.height_m;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int row = 0; row < 2; ++row) {
    const double radius = row == 0 ? cylinder.top_radius_m : cylinder.radius_m;
    const double z = row == 0 ? cylinder.height_m : 0.0;
    for (int i = 0; i <= cylinder.segments; ++i) {
      const double part = static_cast<double>(i) / cylinder.segments;
      const double angle = 2.0 * 3.14159265358979 * part;
      const Vector3d out(std::cos(angle), std::sin(angle), 0.0);
      const Vector2d uv = pen.uv_offset + Vector2d(part * repetitions, (cylinder.height_m - z) /
                                                                           pen.texture_size_m.y());
      AddVertex(mesh, pen, radius * out + z * Vector3d::UnitZ(), out + slope * Vector3d::UnitZ(),
                uv);
    }
  }
  AddGridIndices(mesh, first, 2, cylinder.segments + 1);
}

void AddCylinderEnds(Mesh& mesh, const Pen& pen, const Cylinder& cylinder) {
  for (const bool top : {false, true}) {
    const double z = top ? cylinder.height_m : 0.0;
    const double radius = top ? cylinder.top_radius_m : cylinder.radius_m;
    const Vector3d normal(0, 0, top ? 1.0 : -1.0);
    const std::uint32_t middle =
        AddVertex(mesh, pen, z * Vector3d::UnitZ(), normal, Vector2d(0.5, 0.5));
    for (int i = 0; i <= cylinder.segments; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / cylinder.segments;
      const Vector2d out(std::cos(angle), std::sin(angle));
      AddVertex(mesh, pen, {radius * out.x(), radius * out.y(), z}, normal,
                Vector2d(0.5, 0.5) + 0.5 * out);
      if (i == 0) continue;
      const auto rim = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
      for (const std::uint32_t index : {middle, rim - 1, rim}) mesh.indices.push_back(index);
    }
  }
}

void AddLattice(Mesh& mesh, const Pen& pen, const Lattice& lattice) {
  const auto at = [&](int r, int c) -> const Vector3d& {
    return lattice
        .points[static_cast<std::size_t>(std::clamp(r, 0, lattice.rows - 1)) * lattice.columns +
                std::clamp(c, 0, lattice.columns - 1)];
  };
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  std::vector<double> along(lattice.columns, 0.0);
  for (int r = 0; r < lattice.rows; ++r) {
    double across = 0.0;
    for (int c = 0; c < lattice.columns; ++c) {
      along[c] += (at(r, c) - at(r - 1, c)).norm();
      across += (at(r, c) - at(r, c - 1)).norm();
      Vector3d normal = (at(r + 1, c) - at(r - 1, c)).cross(at(r, c + 1) - at(r, c - 1));
      if (normal.norm() < 1e-12) normal = Vector3d::UnitZ();
      AddVertex(mesh, pen, at(r, c), normal.normalized(), InMetres(pen, {along[c], across}));
    }
  }
  AddGridIndices(mesh, first, lattice.rows, lattice.columns);
}

void AddBall(Mesh& mesh, const Pen& pen, double radius_m, int cells) {
  for (int face = 0; face < 6; ++face) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const Vector2d tile(face % 4, face / 4);
    for (int r = 0; r <= cells; ++r) {
      for (int c = 0; c <= cells; ++c) {
        const Vector2d at(2.0 * c / cells - 1.0, 2.0 * r / cells - 1.0);
        const Vector3d out = CubeDirection(face, at.x(), at.y());
        const Vector2d in_tile = Vector2d(0.5, 0.5) + 0.5 * kBallTileFill * at;
        AddVertex(mesh, pen, radius_m * out, out,
                  (tile + in_tile).cwiseQuotient(Vector2d(4.0, 2.0)));
      }
    }
    AddGridIndices(mesh, first, cells + 1, cells + 1);
  }
}

void AddBlob(Mesh& mesh, const Pen& pen, const Vector3d& radii_m, double roughness, Rng& rng) {
  // Bumps along fixed directions keep the faces of the cube joined.
  std::vector<Vector3d> bumps;
  for (int i = 0; i < 14; ++i) {
    const double x = rng.Normal();
    const double y = rng.Normal();
    bumps.push_back(Vector3d(x, y, rng.Normal()).normalized());
  }
  const auto surface = [&](int face, double a, double b) -> Vector3d {
    const Vector3d out = CubeDirection(face, a, b);
    double height = -0.5;
    for (const Vector3d& bump : bumps) height = std::max(height, 6.0 * out.dot(bump) - 5.0);
    return (1.0 + roughness * height) * out.cwiseProduct(radii_m);
  };
  constexpr int kCells = 3;
  for (int face = 0; face < 6; ++face) {
    for (int r = 0; r < kCells; ++r) {
      for (int c = 0; c < kCells; ++c) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const Vector3d facet =
            CubeDirection(face, (2.0 * c + 1.0) / kCells - 1.0, (2.0 * r + 1.0) / kCells - 1.0);
        for (int corner = 0; corner < 4; ++corner) {
          const Vector3d p = surface(face, 2.0 * (c + corner % 2) / kCells - 1.0,
                                     2.0 * (r + corner / 2) / kCells - 1.0);
          AddVertex(mesh, pen, p, (facet + p.cwiseQuotient(radii_m)).normalized(),
                    InMetres(pen, BoxMapping(p, facet)));
        }
        AddGridIndices(mesh, first, 2, 2);
      }
    }
  }
}

void FitTo(Model& model, const Vector3d& size_m) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());
  Vector3d high = -low;
  for (const Part& part : model.parts) {
    for (const Vertex& vertex : part.mesh.vertices) {
      low = low.cwiseMin(vertex.position.cast<double>());
      high = high.cwiseMax(vertex.position.cast<double>());
    }
  }
  Require((high - low).minCoeff() > 0.0, "FitTo: the model must have a volume");
  const Vector3d middle = 0.5 * (low + high);
  const Vector3d scale = size_m.cwiseQuotient(high - low);
  for (Part& part : model.parts) {
    for (Vertex& vertex : part.mesh.vertices) {
      const Vector3d p = (vertex.position.cast<double>() - middle).cwiseProduct(scale);
      vertex.position = p.cast<float>();
      vertex.normal = vertex.normal.cast<double>().cwiseQuotient(scale).normalized().cast<float>();
    }
  }
  for (CollisionShape& shape : model.shapes) {
    shape.model_from_shape =
        RigidTransform(Eigen::Quaterniond(shape.model_from_shape.rotation()),
                       (shape.model_from_shape.translation() - middle).cwiseProduct(scale));
    shape.half_size_m = shape.half_size_m.cwiseProduct(scale);
    shape.radius_m *= scale.x();
  }
  model.size_m = size_m;
}

Pen PenFor(const Texture& texture, Rng& look) {
  const double u = look.Uniform();
  return {texture.size_m, {u, look.Uniform()}, {}};
}

Part MakePart(const Texture& texture) {
  Part part;
  part.texture = texture.image;
  return part;
}

Part MakeShellPart(const Texture& texture) {
  Part part = MakePart(texture);
  part.casts_shadow = false;
  return part;
}

CollisionShape MakeBoxShape(const Vector3d& low, const Vector3d& high) {
  CollisionShape shape;
  shape.model_from_shape =
      RigidTransform(Eigen::Quaterniond::Identity(), Vector3d(0.5 * (low + high)));
  shape.half_size_m = 0.5 * (high - low);
  return shape;
}

}  // namespace cvo::synth
