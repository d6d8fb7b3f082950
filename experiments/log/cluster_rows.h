// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "core/geometry/stereo_camera.h"
#include "experiments/log/run_record.h"

namespace cvo {

// A live cluster in a frame, as reported when the frame was processed and as last estimated. At
// least one of the two is set.
struct ClusterRow {
  const FrameRecord& frame;
  ClusterId id;
  const ClusterReport* causal = nullptr;   // null: not yet confirmed when the frame was processed
  const ClusterReport* refined = nullptr;  // null: the run failed

  const ClusterReport& Last() const { return refined ? *refined : *causal; }
  RigidTransform CameraFromBox() const;
};

// Calls `take` for all rows of a run, by frame, then by id. A row is valid only during the call.
void ForEachClusterRow(const RunResult& run, const std::function<void(const ClusterRow&)>& take);

// Returns the bounding rectangle of the part of the cluster's 3D box that is in front of the
// camera, clipped to the image. Empty if nothing of it is visible.
[[nodiscard]] std::optional<ImageBox> ProjectedBox(const ClusterRow& row,
                                                   const StereoCamera& camera);

}  // namespace cvo
