// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "experiments/record/run_record.h"

namespace cvo {

// A live cluster in a frame, with poses as last estimated where the run has them (else both the
// camera's and the cluster's as they were when the frame came). The run must outlive it.
struct ClusterRow {
  const FrameRecord& frame;
  const ClusterReport& report;
  const ClusterPose* refined = nullptr;
  RigidTransform camera_from_object;

  RigidTransform CameraFromBox() const { return camera_from_object * report.box.object_from_box; }
};

// By frame, then by id.
std::vector<ClusterRow> ClusterRows(const RunResult& run);

// The rectangle around the part of the cluster's 3D box that is in front of the camera, within the
// image. Empty where none of it is.
[[nodiscard]] std::optional<ImageBox> ProjectedBox(const ClusterRow& row,
                                                   const StereoCamera& camera);

}  // namespace cvo
