// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/aligned_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

using Point = std::array<double, 3>;
using Matrix3 = std::array<std::array<double, 3>, 3>;
using Matrix4 = std::array<std::array<double, 4>, 4>;

Point MeanOfPoints(const std::vector<Point>& points) {
  Point mean{};
  for (const Point& point : points) {
    for (std::size_t k = 0; k < 3; ++k) mean[k] += point[k] / static_cast<double>(points.size());
  }
  return mean;
}

// Applies one Jacobi rotation, which makes a[p][q] zero, and rotates the columns of v along with
// it.
void Rotate(std::size_t p, std::size_t q, Matrix4& a, Matrix4& v) {
  if (a[p][q] == 0.0) return;
  const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double c = 1.0 / std::hypot(t, 1.0);
  const double s = t * c;
  for (std::size_t k = 0; k < 4; ++k) {
    const double kp = a[k][p];
    a[k][p] = c * kp - s * a[k][q];
    a[k][q] = s * kp + c * a[k][q];
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const double pk = a[p][k];
    a[p][k] = c * pk - s * a[q][k];
    a[q][k] = s * pk + c * a[q][k];
  }
  for (auto& row : v) {
    const double at_p = row[p];
    row[p] = c * at_p - s * row[q];
    row[q] = s * at_p + c * row[q];
  }
}

// The eigenvector of the largest eigenvalue of a symmetric matrix.
std::array<double, 4> LargestEigenvector(Matrix4 a) {
  Matrix4 v{};
  for (std::size_t i = 0; i < 4; ++i) v[i][i] = 1.0;
  constexpr int kSweeps = 30;  // quadratic convergence needs fewer than ten
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t p = 0; p < 3; ++p) {
      for (std::size_t q = p + 1; q < 4; ++q) Rotate(p, q, a, v);
    }
  }
  const std::array<double, 4> values = {a[0][0], a[1][1], a[2][2], a[3][3]};
  const auto largest =
      static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  return {v[0][largest], v[1][largest], v[2][largest], v[3][largest]};
}

// The rotation matrix of the quaternion w, x, y, z.
Matrix3 RotationOf(const std::array<double, 4>& quaternion) {
  const auto& [w, x, y, z] = quaternion;
  return {{{w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)},
           {2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)},
           {2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
}

// The rotation from the centred estimate to the centred truth that minimises the squared distances.
// `s` is the sum of products of their coordinates.
Matrix3 BestRotation(const Matrix3& s) {
  Matrix4 n{};
  n[0] = {s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]};
  n[1] = {n[0][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]};
  n[2] = {n[0][2], n[1][2], -s[0][0] + s[1][1] - s[2][2], s[1][2] + s[2][1]};
  n[3] = {n[0][3], n[1][3], n[2][3], -s[0][0] - s[1][1] + s[2][2]};
  return RotationOf(LargestEigenvector(n));
}

}  // namespace

std::vector<double> AlignedErrors(const std::vector<Point>& estimate,
                                  const std::vector<Point>& truth) {
  Require(estimate.size() == truth.size(), "AlignedErrors: as many estimated as true positions");
  const Point from_mean = MeanOfPoints(estimate);
  const Point to_mean = MeanOfPoints(truth);
  Matrix3 products{};  // sums of products of estimate and truth
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        products[j][k] += (estimate[i][j] - from_mean[j]) * (truth[i][k] - to_mean[k]);
      }
    }
  }
  const Matrix3 rotation = BestRotation(products);
  std::vector<double> errors_m;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    double squares = 0.0;
    for (std::size_t j = 0; j < 3; ++j) {
      double off = to_mean[j] - truth[i][j];
      for (std::size_t k = 0; k < 3; ++k) {
        off += rotation[j][k] * (estimate[i][k] - from_mean[k]);
      }
      squares += off * off;
    }
    errors_m.push_back(std::sqrt(squares));
  }
  return errors_m;
}

}  // namespace cvo::reports
