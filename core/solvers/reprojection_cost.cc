// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/reprojection_cost.h"

#include "core/features/stereo_feature.h"

namespace cvo {

namespace {

// Whitening matrix for these standard deviations.
Eigen::Matrix3d Whitening(double corner_px, double disparity_px) {
  const double corner = 1.0 / corner_px;
  const double disparity = 1.0 / disparity_px;
  Eigen::Matrix3d W;
  W << corner, 0.0, 0.0,  //
      0.0, corner, 0.0,   //
      disparity, 0.0, -disparity;
  return W;
}

}  // namespace

Eigen::Matrix3d SqrtInformation(const NoiseOptions& noise, double scale) {
  return Whitening(noise.corner_px * scale, noise.disparity_px * scale);
}

Eigen::Matrix3d MeasurementCovariance(const NoiseOptions& noise, double scale) {
  const double corner = noise.corner_px * noise.corner_px * scale * scale;
  const double disparity = noise.disparity_px * noise.disparity_px * scale * scale;
  Eigen::Matrix3d covariance;
  covariance << corner, 0.0, corner,  //
      0.0, corner, 0.0,               //
      corner, 0.0, corner + disparity;
  return covariance;
}

Eigen::Matrix3d FeatureNoise::SqrtInformation(int octave, bool is_aligned,
                                              double disagreement_px) const {
  const double scale = std::pow(scale_factor, octave);
  double disparity_px = options.disparity_px;
  if (HasNoDisparity(disagreement_px)) {
    disparity_px = disagreement_px;
  } else if (options.disagreement > 0.0) {
    disparity_px = std::hypot(options.least_disparity_px, options.disagreement * disagreement_px);
  }
  return Whitening((is_aligned ? options.aligned_px : options.corner_px) * scale,
                   disparity_px * scale);
}

Eigen::Matrix3d FeatureNoise::Covariance(int octave) const {
  return MeasurementCovariance(options, std::pow(scale_factor, octave));
}

ReprojectionResidual EvaluateReprojection(const StereoCamera& camera, const Eigen::Vector3d& z_px,
                                          const Eigen::Matrix3d& sqrt_information,
                                          const RigidTransform& world_from_camera,
                                          const Eigen::Vector3d& p_in_world) {
  const Eigen::Matrix3d R = world_from_camera.RotationMatrix().transpose();
  const Eigen::Vector3d c = R * (p_in_world - world_from_camera.translation());
  const ProjectionResidual projection = EvaluateProjection(camera, z_px, sqrt_information, c);
  ReprojectionResidual result;
  result.r = projection.r;
  result.J_point = projection.J * R;
  result.J_pose.leftCols<3>() = projection.J * Skew(c);
  result.J_pose.rightCols<3>() = -result.J_point;
  result.J_field = sqrt_information.col(2) *
                   camera.BasisAt(projection.zeta_px[0], projection.zeta_px[1]).value.transpose();
  return result;
}

}  // namespace cvo
