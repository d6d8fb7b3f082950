// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/import/stereo_rig.h"

namespace cvo {

bool IsRectified(const StereoRig& rig) {
  const LensCamera& a = rig.left;
  const LensCamera& b = rig.right;
  const Eigen::Vector3d t = rig.right_from_left.translation();
  return a.lens == LensModel::kPinhole && b.lens == LensModel::kPinhole && a.fx == b.fx &&
         a.fy == b.fy && a.cx == b.cx && a.cy == b.cy && t.x() < 0.0 && t.y() == 0.0 &&
         t.z() == 0.0 &&
         rig.right_from_left.RotationMatrix() == Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

}  // namespace cvo
