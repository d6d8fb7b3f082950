// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/write_run.h"

#include "experiments/metrics/kitti_poses.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/metrics/tum_trajectory.h"
#include "experiments/record/atomic_file.h"

namespace cvo {

std::vector<std::string> RunFileNames() {
  return {"camera.tum", "camera.kitti", "timing.json", "result.json"};
}

void WriteRun(const std::filesystem::path& folder, const RunRecord& record,
              const RunContext& context) {
  Trajectory timed;
  std::vector<RigidTransform> every_frame;
  for (const FrameRecord& frame : record.run.frames) {
    every_frame.push_back(frame.refined_world_from_camera);
    if (frame.report.status == FrameStatus::kSkipped) continue;
    timed.push_back({frame.timestamp_ns, frame.refined_world_from_camera});
  }
  // The result last: where it is complete, so is all else.
  WriteFilesAtomically(folder, {{"camera.tum", FormatTumTrajectory(timed)},
                                {"camera.kitti", FormatKittiPoses(every_frame)},
                                {"timing.json", TimingFile(record.run, context)},
                                {"result.json", ResultFile(record)}});
}

}  // namespace cvo
