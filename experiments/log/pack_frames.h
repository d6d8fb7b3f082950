// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <type_traits>

#include "core/interface/odometry.h"
#include "experiments/log/frame_log.h"

namespace cvo {

// The fields of a frame and of a pose that a Packer packs: all except FrameReport::landmarks, which
// are not kept.

template <typename T, typename Record>
concept Packs = std::same_as<std::remove_const_t<T>, Record>;

void Visit(Packs<Detection> auto& detection, auto& archive) {
  archive(detection.box, detection.category, detection.score);
}

void Visit(Packs<ImageProblem> auto& problem, auto& archive) {
  archive(problem.image, problem.reason);
}

void Visit(Packs<ClusterReport> auto& cluster, auto& archive) {
  archive(cluster.id, cluster.category, cluster.status, cluster.world_from_object,
          cluster.velocity_m_s, cluster.center_in_object, cluster.half_size_m,
          cluster.box.object_from_box, cluster.box.size_m, cluster.observed_landmarks,
          cluster.detection, cluster.score);
}

void Visit(Packs<ClusterPose> auto& pose, auto& archive) {
  using Report = std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(pose)>>,
                                    const ClusterReport, ClusterReport>;
  archive(static_cast<Report&>(pose), pose.frame, pose.timestamp_ns);
}

void Visit(Packs<FrameReport> auto& report, auto& archive) {
  archive(report.status, report.world_from_camera, report.features, report.matches, report.inliers,
          report.new_landmarks, report.window_frames, report.spatial_ages, report.window_landmarks,
          report.window_iterations, report.window_endings, report.cluster_endings,
          report.calibration.right_field_px, report.calibration.information, report.mean_error_px,
          report.clusters);
}

void Visit(Packs<FrameRecord> auto& frame, auto& archive) {
  archive(frame.frame, frame.timestamp_ns, frame.report, frame.refined_world_from_camera,
          frame.detections, frame.landmarks, frame.problems);
}

}  // namespace cvo
