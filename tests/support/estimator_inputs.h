// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/rng.h"
#include "core/clustering/dense_crf.h"
#include "core/features/descriptor.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/frame.h"

// Cameras, features, poses and landmarks to label for tests of the estimator.
namespace cvo::test {

// Returns a camera with square pixels and the principal point in the middle of the image.
inline StereoCamera CentredCamera(double focal_px, double baseline_m, int width_px, int height_px) {
  return {.fx = focal_px,
          .fy = focal_px,
          .cx = 0.5 * width_px,
          .cy = 0.5 * height_px,
          .baseline_m = baseline_m,
          .width_px = width_px,
          .height_px = height_px};
}

// Returns a random descriptor: unique as far as matching is concerned.
inline Descriptor RandomDescriptor(Rng& rng) {
  return {rng.NextU64(), rng.NextU64(), rng.NextU64(), rng.NextU64()};
}

// Returns the patch disagreement of a feature whose disparity has the given standard deviation. In
// rendered rooms, 1.48 times the median absolute disparity error is 1.6 times the median
// disagreement.
inline float DisagreementOf(double disparity_px) { return static_cast<float>(disparity_px / 1.6); }

// Returns one frame of a cluster trajectory. Fields that are not given are taken from `report`.
inline ClusterPose PoseInFrame(std::int64_t frame, std::int64_t timestamp_ns, ClusterStatus status,
                               const RigidTransform& world_from_object, ClusterReport report = {}) {
  report.status = status;
  report.world_from_object = world_from_object;
  return {report, frame, timestamp_ns};
}

inline const StereoCamera kSceneCamera = {.fx = 700,
                                          .fy = 700,
                                          .cx = 600,
                                          .cy = 180,
                                          .baseline_m = 0.5,
                                          .width_px = 1242,
                                          .height_px = 375,
                                          .right_shift_px = 0.1};

// Of worlds that give features without images.
inline const StereoCamera kFeatureCamera = {.fx = 450.0,
                                            .fy = 450.0,
                                            .cx = 319.5,
                                            .cy = 239.5,
                                            .baseline_m = 0.3,
                                            .width_px = 640,
                                            .height_px = 480};

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
