// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/base/options.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Noise of z = (u_left, v, u_right). The error of the corner shifts u_left and u_right together,
// because u_right is found by aligning the patch around that same corner. The disparity has a
// smaller error of its own. Both grow with the scale of the pyramid level.
struct NoiseOptions {
  double corner_px = 0.5;
  double aligned_px = 0.2;
  double disparity_px = 0.3;
  double least_disparity_px = 0.05;
  double disagreement = 3.0;
  double right_mean_px = 0.03;
  double right_field_px = 0.06;
  double row_field_px = 0.03;
  double huber = 2.796;
  double gate = 7.815;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("corner_px", self.corner_px,
                {"px", 0.01, 10, "standard deviation of u_left and v at level 0",
                 "residuals on KITTI: 0.35-0.45 px at level 0, growing with the level's scale"});
    visit.Field("aligned_px", self.aligned_px,
                {"px", 0.01, 10,
                 "standard deviation of u_left and v at level 0, for corners that were aligned "
                 "with their landmark's first patch",
                 "METHOD.md 3.4: residuals are 0.05-0.1 px on KITTI, 0.04 px on rendered streets"});
    visit.Field("disparity_px", self.disparity_px,
                {"px", 0.01, 10, "standard deviation of u_left - u_right at level 0",
                 "residuals on KITTI: 0.15-0.2 px, and 0.1-0.2 px of rectification error"});
    visit.Field(
        "least_disparity_px", self.least_disparity_px,
        {"px", 0.001, 10,
         "standard deviation of a disparity, as used in energies, if all parts of its patch agree",
         "METHOD.md 7.2: residuals are 0.05 px on rendered rooms, 0.1 px on KITTI"});
    visit.Field("disagreement", self.disagreement,
                {"1", 0, 1000,
                 "standard deviation of a disparity, as used in energies, per pixel of "
                 "disagreement between the quarters of its patch; 0: noise.disparity_px for all",
                 "METHOD.md 7.2: chosen from 3, 5 and 6 on rooms, streets and KITTI"});
    visit.Field("right_mean_px", self.right_mean_px,
                {"px", 0, 10,
                 "prior standard deviation of the mean over the image of the calibration error of "
                 "u_right; 0 trusts the calibration",
                 "METHOD.md 7.6: chosen from 0.02 ... 0.3 on KITTI, streets and rooms"});
    visit.Field("right_field_px", self.right_field_px,
                {"px", 0, 10,
                 "prior standard deviation of each other coefficient of the calibration error of "
                 "u_right; 0 for one constant over the image",
                 "METHOD.md 7.6: KITTI's are 0.05-1 px"});
    visit.Field(
        "row_field_px", self.row_field_px,
        {"px", 1e-6, 1e6,
         "standard deviation of each coefficient of the row offset from what the calibration "
         "error of u_right implies; large: rows are not used",
         "METHOD.md 7.6: chosen from 0.02 ... 0.5 on KITTI and streets"});
    visit.Field("huber", self.huber,
                {"standard deviations", 0.1, 1e6,
                 "threshold at which the Huber loss becomes linear: sqrt(7.815)", "METHOD.md 7.2"});
    visit.Field("gate", self.gate,
                {"1", 0.1, 1e6,
                 "maximum squared whitened error of an inlier: 95 % quantile of chi^2 with 3 "
                 "degrees of freedom",
                 "METHOD.md 3.2"});
  }
};

// Returns W such that W^T W is the inverse covariance of z; `scale` = scale_factor^octave.
Eigen::Matrix3d SqrtInformation(const NoiseOptions& noise, double scale);

// Returns the covariance of z, px^2.
Eigen::Matrix3d MeasurementCovariance(const NoiseOptions& noise, double scale);

// Noise of features, depending on the pyramid level at which they were found.
struct FeatureNoise {
  NoiseOptions options;
  double scale_factor = 1.0;  // ratio between adjacent levels

  // For a feature, or an observation of one.
  Eigen::Matrix3d SqrtInformation(const auto& seen) const {
    return SqrtInformation(seen.octave, seen.is_aligned, seen.disagreement_px);
  }
  // `disagreement_px` in px of the level.
  Eigen::Matrix3d SqrtInformation(int octave, bool is_aligned, double disagreement_px) const;
  Eigen::Matrix3d Covariance(int octave) const;  // of a feature that is not aligned
};

// Weight rho'(s) of the Huber loss for a residual with this squared whitened norm.
inline double HuberWeight(double squared_norm, double huber) {
  return squared_norm <= huber * huber ? 1.0 : huber / std::sqrt(squared_norm);
}

// The Huber loss rho(s): the squared norm up to `huber`, linear in the norm beyond.
inline double HuberLoss(double squared_norm, double huber) {
  return squared_norm <= huber * huber ? squared_norm
                                       : huber * (2.0 * std::sqrt(squared_norm) - huber);
}

// Moves a point that is nearer than StereoCamera::kMinDepth_m to just beyond that depth, so that
// its residual stays finite.
inline Eigen::Vector3d InFront(const Eigen::Vector3d& p_in_camera) {
  return {p_in_camera.x(), p_in_camera.y(),
          std::max(p_in_camera.z(), 1.001 * StereoCamera::kMinDepth_m)};
}

// r = W (pi(p_in_camera) - z), with near points moved by InFront.
inline Eigen::Vector3d EvaluateResidual(const StereoCamera& camera, const Eigen::Vector3d& z_px,
                                        const Eigen::Matrix3d& sqrt_information,
                                        const Eigen::Vector3d& p_in_camera) {
  return sqrt_information * (*camera.Project(InFront(p_in_camera)) - z_px);
}

// The same r, and its 3x3 Jacobian with respect to p_in_camera.
struct ProjectionResidual {
  Eigen::Vector3d r;
  Eigen::Matrix3d J;
  Eigen::Vector3d zeta_px;  // pi(p_in_camera)
};
inline ProjectionResidual EvaluateProjection(const StereoCamera& camera,
                                             const Eigen::Vector3d& z_px,
                                             const Eigen::Matrix3d& sqrt_information,
                                             const Eigen::Vector3d& p_in_camera) {
  const Eigen::Vector3d c = InFront(p_in_camera);
  const Eigen::Vector3d zeta_px = *camera.Project(c);
  return {sqrt_information * (zeta_px - z_px), sqrt_information * camera.ProjectionJacobian(c),
          zeta_px};
}

// r = W (pi(camera_from_world p) - z), the reprojection term of the paper's static energy. J_pose
// (3x6) is in the tangent of world_from_camera, J_point (3x3) is with respect to p_in_world, and
// J_field (3x6) with respect to camera.right_field_px. Near points are moved by InFront.
struct ReprojectionResidual {
  Eigen::Vector3d r;
  Eigen::Matrix<double, 3, 6> J_pose;
  Eigen::Matrix3d J_point;
  Eigen::Matrix<double, 3, 6> J_field;
};
ReprojectionResidual EvaluateReprojection(const StereoCamera& camera, const Eigen::Vector3d& z_px,
                                          const Eigen::Matrix3d& sqrt_information,
                                          const RigidTransform& world_from_camera,
                                          const Eigen::Vector3d& p_in_world);

}  // namespace cvo
