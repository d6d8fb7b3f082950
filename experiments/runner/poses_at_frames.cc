// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/poses_at_frames.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/files/number.h"
#include "experiments/metrics/association.h"
#include "experiments/metrics/kitti_poses.h"
#include "experiments/metrics/pose_format.h"
#include "experiments/metrics/tum_trajectory.h"

namespace cvo {
namespace {

bool IsPart(const Sequence& sequence) {
  return sequence.images.size() < static_cast<std::size_t>(sequence.total_frames);
}

OptionalPoses ReadKittiAtFrames(const std::filesystem::path& path, const Sequence& sequence) {
  const std::vector<RigidTransform> poses = ReadKittiPoses(path);
  const std::size_t frames = sequence.images.size();
  const auto total = static_cast<std::size_t>(sequence.total_frames);
  if (poses.size() != total && poses.size() != frames) {
    ThrowError(StrCat(path.string(), ":", poses.size()),
               StrCat("the last of ", poses.size(), " poses"),
               StrCat(total, ", one per frame of ", sequence.name,
                      IsPart(sequence) ? StrCat(", or ", frames, ", one per frame read") : ""));
  }
  const auto skip = poses.size() == total ? sequence.first_frame : 0;
  return {poses.begin() + skip, poses.begin() + skip + static_cast<std::ptrdiff_t>(frames)};
}

}  // namespace

OptionalPoses ReadTumAtFrames(const std::filesystem::path& path, const Sequence& sequence) {
  const Trajectory trajectory = ReadTumTrajectory(path);
  Trajectory frames;
  for (const std::int64_t time_ns : sequence.timestamps_ns) frames.push_back({time_ns, {}});
  const TimeAssociation association = AssociateByTime(frames, trajectory);
  std::vector<bool> matched(trajectory.size());
  for (const auto& [frame, pose] : association.pairs) matched[pose] = true;
  const std::int64_t first_ns = sequence.timestamps_ns.front();
  const std::int64_t last_ns = sequence.timestamps_ns.back();
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const std::int64_t time_ns = trajectory[i].timestamp_ns;
    const bool outside = time_ns < first_ns || time_ns > last_ns;
    if (matched[i] || (outside && IsPart(sequence))) continue;
    ThrowError(WhereTumPose(path, i), "time " + FormatSecondsNs(time_ns),
               StrCat("that of a frame, one pose for each, to within ",
                      FormatSecondsNs(kDefaultAssociation_ns), " s; frames are from ",
                      FormatSecondsNs(first_ns), " to ", FormatSecondsNs(last_ns), " s"));
  }
  return PosesAtFrames(association, frames.size(), trajectory);
}

OptionalPoses ReadCameraAtFrames(const std::filesystem::path& path, const Sequence& sequence) {
  OptionalPoses poses = DetectPoseFormat(path) == "tum" ? ReadTumAtFrames(path, sequence)
                                                        : ReadKittiAtFrames(path, sequence);
  const auto found =
      std::count_if(poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); });
  if (found < 2) {
    ThrowError(path.string(), StrCat(found, " poses of the frames that are read"), "2 or more");
  }
  return poses;
}

}  // namespace cvo
