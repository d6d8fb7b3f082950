// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "experiments/record/run_record.h"

namespace cvo {

// A live cluster in a frame, as reported when the frame came and as last estimated; at least one of
// the two. The run must outlive it.
struct ClusterRow {
  const FrameRecord& frame;
  ClusterId id;
  const ClusterReport* causal = nullptr;   // null: not yet confirmed when the frame came
  const ClusterReport* refined = nullptr;  // null: the run failed

  const ClusterReport& Last() const { return refined ? *refined : *causal; }
  RigidTransform CameraFromBox() const;
};

// By frame, then by id.
std::vector<ClusterRow> ClusterRows(const RunResult& run);

// The rectangle around the part of the cluster's 3D box that is in front of the camera, within the
// image. Empty where none of it is.
[[nodiscard]] std::optional<ImageBox> ProjectedBox(const ClusterRow& row,
                                                   const StereoCamera& camera);

}  // namespace cvo
