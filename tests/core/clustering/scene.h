// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clustering/dense_crf.h"

namespace cvo::test {

inline const StereoCamera kSceneCamera = {.fx = 700,
                                          .fy = 700,
                                          .cx = 600,
                                          .cy = 180,
                                          .baseline_m = 0.5,
                                          .width_px = 1242,
                                          .height_px = 375,
                                          .right_shift_px = 0.1};

inline CrfLabel MakeLabel(LabelKind kind) {
  CrfLabel label;
  label.kind = kind;
  return label;
}

// Returns a landmark observed without error, whose position has a standard deviation of 1 cm.
inline CrfNode NodeAt(const Eigen::Vector3d& p_in_camera) {
  CrfNode node;
  node.z_px = *kSceneCamera.Project(p_in_camera);
  node.p_in_camera = p_in_camera;
  node.covariance_m2 = 1e-4 * Eigen::Matrix3d::Identity();
  return node;
}

}  // namespace cvo::test
