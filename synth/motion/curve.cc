// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "synth/motion/motion.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;

constexpr int kCells = 16;  // per piece, each integrated by one Gauss-Legendre rule
constexpr double kLeastGap_m = 1e-3;

struct Derivatives {
  Vector3d position;
  Vector3d first;
  Vector3d second;
};

template <typename Piece>
Derivatives Evaluate(const Piece& piece, double u) {
  Derivatives at{piece.col(7), Vector3d::Zero(), Vector3d::Zero()};
  for (int k = 6; k >= 0; --k) {  // Horner's rule for the value and its derivatives
    at.second = at.second * u + at.first;
    at.first = at.first * u + at.position;
    at.position = at.position * u + piece.col(k);
  }
  at.second *= 2.0;
  return at;
}

// Arc length from u0 to u1 by the five-point Gauss-Legendre rule.
template <typename Piece>
double ArcLength(const Piece& piece, double u0, double u1) {
  constexpr std::array<double, 3> kNodes = {0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> kWeights = {0.5688888888888889, 0.4786286704993665,
                                              0.2369268850561891};
  const double middle = 0.5 * (u0 + u1);
  const double half = 0.5 * (u1 - u0);
  double sum = kWeights[0] * Evaluate(piece, middle).first.norm();
  for (std::size_t i = 1; i < kNodes.size(); ++i) {
    sum += kWeights[i] * (Evaluate(piece, middle - half * kNodes[i]).first.norm() +
                          Evaluate(piece, middle + half * kNodes[i]).first.norm());
  }
  return half * sum;
}

void CheckPoints(const std::vector<Vector3d>& points, bool closed, const std::string& where) {
  const std::size_t n = points.size();
  if (closed && n < 3) ThrowError(where, StrCat(n, " points"), "at least 3 on a closed curve");
  for (std::size_t i = 0; i + 1 < n + (closed ? 1 : 0); ++i) {
    if ((points[(i + 1) % n] - points[i]).norm() < kLeastGap_m) {
      ThrowError(where, StrCat("points ", i, " and ", (i + 1) % n, " at the same place"),
                 "points at least 1 mm apart");
    }
  }
}

// A linear condition on the first ([knot]) and second ([knots + knot]) derivatives at the knots.
struct Condition {
  Eigen::RowVectorXd lhs;
  Eigen::RowVector3d rhs;
};

// An interval between two knots. Its quintic is given by the value and the first and second
// derivatives at both ends.
struct Interval {
  Eigen::Index from, to, knots;
  double h;
  Vector3d step;
};

// Adds `sign` times the third derivative at the start or end of the interval to the condition.
void AddThird(const Interval& i, bool at_end, double sign, Condition& condition) {
  const double near1 = -36.0 / (i.h * i.h), far1 = -24.0 / (i.h * i.h);
  const double near2 = (at_end ? 9.0 : -9.0) / i.h, far2 = (at_end ? -3.0 : 3.0) / i.h;
  const Eigen::Index near = at_end ? i.to : i.from, far = at_end ? i.from : i.to;
  condition.lhs[near] += sign * near1;
  condition.lhs[far] += sign * far1;
  condition.lhs[i.knots + near] += sign * near2;
  condition.lhs[i.knots + far] += sign * far2;
  condition.rhs -= sign * 60.0 / (i.h * i.h * i.h) * i.step.transpose();
}

// The same for the fourth derivative.
void AddFourth(const Interval& i, bool at_end, double sign, Condition& condition) {
  const double side = at_end ? -1.0 : 1.0;
  const double h2 = i.h * i.h, h3 = h2 * i.h;
  const Eigen::Index near = at_end ? i.to : i.from, far = at_end ? i.from : i.to;
  condition.lhs[near] += sign * side * 192.0 / h3;
  condition.lhs[far] += sign * side * 168.0 / h3;
  condition.lhs[i.knots + near] += sign * 36.0 / h2;
  condition.lhs[i.knots + far] -= sign * 24.0 / h2;
  condition.rhs += sign * side * 360.0 / (h3 * i.h) * i.step.transpose();
}

std::vector<Interval> MakeIntervals(const std::vector<Vector3d>& points, bool closed) {
  const auto knots = static_cast<Eigen::Index>(points.size());
  std::vector<Interval> intervals;
  for (Eigen::Index i = 0; i + 1 < knots + (closed ? 1 : 0); ++i) {
    const Eigen::Index next = (i + 1) % knots;
    const Vector3d step = points[next] - points[i];
    intervals.push_back({i, next, knots, step.norm(), step});
  }
  return intervals;
}

// Returns the first derivatives at all knots, then the second derivatives, one per row.
Eigen::MatrixX3d SolveDerivatives(const std::vector<Interval>& intervals, Eigen::Index knots,
                                  bool closed) {
  Eigen::MatrixXd lhs(2 * knots, 2 * knots);
  Eigen::MatrixX3d rhs(2 * knots, 3);
  for (Eigen::Index knot = 0; knot < knots; ++knot) {
    Condition third{Eigen::RowVectorXd::Zero(2 * knots), Eigen::RowVector3d::Zero()};
    Condition fourth = third;
    // Both derivatives are equal on both sides of a knot, and zero at an open end.
    if (closed || knot > 0) {
      const Interval& before = intervals[(knot + intervals.size() - 1) % intervals.size()];
      AddThird(before, true, 1.0, third);
      AddFourth(before, true, 1.0, fourth);
    }
    if (closed || knot + 1 < knots) {
      AddThird(intervals[knot], false, -1.0, third);
      AddFourth(intervals[knot], false, -1.0, fourth);
    }
    lhs.row(2 * knot) = third.lhs;
    lhs.row(2 * knot + 1) = fourth.lhs;
    rhs.row(2 * knot) = third.rhs;
    rhs.row(2 * knot + 1) = fourth.rhs;
  }
  return lhs.partialPivLu().solve(rhs);
}

}  // namespace

std::vector<Curve::Piece> Curve::SplinePieces(const std::vector<Vector3d>& points, bool closed) {
  const auto knots = static_cast<Eigen::Index>(points.size());
  const std::vector<Interval> intervals = MakeIntervals(points, closed);
  const Eigen::MatrixX3d solved = SolveDerivatives(intervals, knots, closed);
  std::vector<Piece> pieces;
  for (const Interval& i : intervals) {
    const Vector3d d0 = i.h * solved.row(i.from), d1 = i.h * solved.row(i.to);
    const Vector3d e0 = i.h * i.h * solved.row(knots + i.from);
    const Vector3d e1 = i.h * i.h * solved.row(knots + i.to);
    Piece piece = Piece::Zero();
    piece.col(0) = points[i.from];
    piece.col(1) = d0;
    piece.col(2) = 0.5 * e0;
    piece.col(3) = 10.0 * i.step - 6.0 * d0 - 4.0 * d1 - 1.5 * e0 + 0.5 * e1;
    piece.col(4) = -15.0 * i.step + 8.0 * d0 + 7.0 * d1 + 1.5 * e0 - e1;
    piece.col(5) = 6.0 * i.step - 3.0 * d0 - 3.0 * d1 - 0.5 * e0 + 0.5 * e1;
    pieces.push_back(piece);
  }
  return pieces;
}

Curve::Piece Curve::Line(const Vector3d& from, const Vector3d& to) {
  Piece piece = Piece::Zero();
  piece.col(0) = from;
  piece.col(1) = to - from;
  return piece;
}

// A Bezier curve of degree seven. Four control points on each leg make the curvature and its
// derivative vanish at both ends.
Curve::Piece Curve::Bend(const Vector3d& corner, const Vector3d& from, const Vector3d& to) {
  constexpr double kReach = 0.62;  // fraction of a leg that its control points span: like an arc
  std::array<Vector3d, 8> controls;
  for (std::size_t i = 0; i < 4; ++i) {
    const double part = kReach * static_cast<double>(i) / 3.0;
    controls[i] = from + part * (corner - from);
    controls[7 - i] = to + part * (corner - to);
  }
  constexpr std::array<double, 8> kFactorials = {1, 1, 2, 6, 24, 120, 720, 5040};
  Piece piece = Piece::Zero();
  for (std::size_t j = 0; j < 8; ++j) {
    for (std::size_t i = 0; i <= j; ++i) {
      const double sign = (i + j) % 2 == 0 ? 1.0 : -1.0;
      const double weight =
          kFactorials[7] / (kFactorials[7 - j] * kFactorials[i] * kFactorials[j - i]);
      piece.col(static_cast<Eigen::Index>(j)) += sign * weight * controls[i];
    }
  }
  return piece;
}

Curve::Curve(std::vector<Piece> pieces, bool closed, const std::string& where)
    : pieces_(std::move(pieces)), closed_(closed) {
  arc_m_.push_back(0.0);
  for (const Piece& piece : pieces_) {
    const double start = arc_m_.back();
    double slowest = piece.col(1).norm();
    for (int k = 0; k < kCells; ++k) {
      const double u1 = (k + 1.0) / kCells;
      slowest = std::min(slowest, Evaluate(piece, u1).first.norm());
      arc_m_.push_back(arc_m_.back() + ArcLength(piece, static_cast<double>(k) / kCells, u1));
    }
    if (pieces_.size() > 1 && slowest < 0.05 * (arc_m_.back() - start)) {
      ThrowError(where, "a curve that turns on the spot", "points that lead around smoothly");
    }
  }
}

Curve Curve::Through(const std::vector<Vector3d>& points, bool closed, const std::string& where) {
  Require(!points.empty(), "a curve has points");
  CheckPoints(points, closed, where);
  if (points.size() <= 2) return {{Line(points.front(), points.back())}, false, where};
  return {SplinePieces(points, closed), closed, where};
}

Curve Curve::Rounded(const std::vector<Vector3d>& points, bool closed, double corner_m,
                     const std::string& where) {
  Require(!points.empty(), "a curve has points");
  CheckPoints(points, closed, where);
  const std::size_t n = points.size();
  if (n <= 2) return {{Line(points.front(), points.back())}, false, where};
  std::vector<Piece> pieces;
  Vector3d at = points.front();
  const auto line_to = [&](const Vector3d& to) {
    if ((to - at).norm() > 1e-9) pieces.push_back(Line(at, to));
    at = to;
  };
  if (closed) at = 0.5 * (points[0] + points[n - 1]);
  const Vector3d start = at;
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
    const Vector3d before = points[(i + n - 1) % n] - points[i];
    const Vector3d behind = points[(i + 1) % n] - points[i];
    const double cosine = before.normalized().dot(behind.normalized());
    if (cosine > 0.9) ThrowError(where, StrCat("a turn back at point ", i), "no such turn");
    if (cosine < -1.0 + 1e-12) continue;  // no turn
    const double cut = std::min({corner_m, 0.5 * before.norm(), 0.5 * behind.norm()});
    line_to(points[i] + cut * before.normalized());
    const Vector3d to = points[i] + cut * behind.normalized();
    pieces.push_back(Bend(points[i], at, to));
    at = to;
  }
  line_to(closed ? start : points.back());
  return {std::move(pieces), closed, where};
}

CurvePoint Curve::At(double s_m) const {
  const double length = length_m();
  if (length <= 0.0) return {pieces_[0].col(0)};
  double s = closed_ ? s_m - length * std::floor(s_m / length) : std::clamp(s_m, 0.0, length);
  const auto above = std::upper_bound(arc_m_.begin(), arc_m_.end(), s);
  const auto cell = std::min<std::size_t>(std::max<std::ptrdiff_t>(above - arc_m_.begin(), 1) - 1,
                                          arc_m_.size() - 2);
  const Piece& piece = pieces_[cell / kCells];
  const double u0 = static_cast<double>(cell % kCells) / kCells;
  double u = u0 + (s - arc_m_[cell]) / (arc_m_[cell + 1] - arc_m_[cell]) / kCells;
  constexpr int kMaxSteps = 10;
  for (int step = 0; step < kMaxSteps; ++step) {  // Newton's method
    const double error = arc_m_[cell] + ArcLength(piece, u0, u) - s;
    u -= error / Evaluate(piece, u).first.norm();
    if (std::abs(error) < 1e-13 * (1.0 + length)) break;
  }
  const Derivatives at = Evaluate(piece, u);
  const double speed = at.first.norm();
  CurvePoint point{at.position, at.first / speed, Vector3d::Zero()};
  const double beyond = closed_ ? 0.0 : s_m - s;
  if (beyond == 0.0) {
    point.curvature = (at.second - point.tangent * point.tangent.dot(at.second)) / (speed * speed);
  }
  point.position += beyond * point.tangent;
  return point;
}

}  // namespace cvo::synth
