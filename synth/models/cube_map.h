// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace cvo::synth {

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

}  // namespace cvo::synth
