// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/calibration/pose_row.h"

#include <Eigen/LU>

#include "core/base/error.h"

namespace cvo {

Eigen::Matrix3d CheckedRotation(const Eigen::Matrix3d& R, const std::string& where) {
  constexpr double kTolerance = 1e-3;
  const double defect = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(defect <= kTolerance)) {
    ThrowError(where, StrCat("a matrix whose R R^T is off the identity by ", defect),
               StrCat("a rotation, off by at most ", kTolerance));
  }
  if (R.determinant() < 0.0) ThrowError(where, "a reflection", "a rotation");
  return NearestRotation(R);
}

RigidTransform TransformFromRow(const std::vector<double>& row, const std::string& where) {
  Require(row.size() == 12, "TransformFromRow: needs twelve numbers");
  Eigen::Matrix3d R;
  R << row[0], row[1], row[2], row[4], row[5], row[6], row[8], row[9], row[10];
  return {CheckedRotation(R, where), Eigen::Vector3d(row[3], row[7], row[11])};
}

}  // namespace cvo
