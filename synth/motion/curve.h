// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace cvo::synth {

// A point of a curve, with derivatives by its arc length s.
struct CurvePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();   // d position / ds, unit length
  Eigen::Vector3d curvature = Eigen::Vector3d::Zero();  // d tangent / ds, 1/m
};

// A space curve parametrised by arc length, smooth enough for a differentiable curvature. An open
// curve continues straight beyond its ends; a closed one repeats.
class Curve {
 public:
  // The quintic spline through the points (chord-length parametrisation), four times
  // differentiable. One point gives a curve of length zero. Throws Error for coincident points and
  // for a cusp.
  static Curve Through(const std::vector<Eigen::Vector3d>& points, bool closed,
                       const std::string& where);
  // Straight legs between the points. A bend within the triangle of each corner replaces it from
  // `corner_m` before to `corner_m` after the corner (less if a leg is short).
  static Curve Rounded(const std::vector<Eigen::Vector3d>& points, bool closed, double corner_m,
                       const std::string& where);

  double length_m() const { return arc_m_.back(); }
  bool closed() const { return closed_; }
  CurvePoint At(double s_m) const;

 private:
  // Columns: coefficients of u^0 ... u^7, u from 0 to 1.
  using Piece = Eigen::Matrix<double, 3, 8>;

  Curve(std::vector<Piece> pieces, bool closed, const std::string& where);
  static std::vector<Piece> SplinePieces(const std::vector<Eigen::Vector3d>& points, bool closed);
  static Piece Line(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  static Piece Bend(const Eigen::Vector3d& corner, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& to);

  std::vector<Piece> pieces_;
  std::vector<double> arc_m_;  // at the start of each cell of each piece, and at the end
  bool closed_ = false;
};

}  // namespace cvo::synth
