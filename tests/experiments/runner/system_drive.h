// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A drive behind two cars, and files that another system could have written for it.

#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/runner/score_files.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {

constexpr int kDriveFrames = 8;
constexpr double kLeftOffset_m = 0.06;  // p_in_read = p_in_camera0 + (offset, 0, 0)

inline RigidTransform DriveCamera(int frame) {
  return {ExpSo3({0.0, 0.02 * frame, 0.0}), Eigen::Vector3d(0.1 * frame, 0.0, frame)};
}

// Pose of a car in the world, with its origin at the centre of its box. Both cars advance by 0.9 m
// per frame; the second one turns.
inline RigidTransform CarInWorld(int track, int frame) {
  const double heading_rad = -1.5 + (track == 1 ? 0.05 * frame : 0.0);
  return {ExpSo3({0.0, heading_rad, 0.0}),
          Eigen::Vector3d(track == 0 ? -2.0 : 4.0, 0.8, 12.0 + 3.0 * track + 0.9 * frame)};
}

// A box as a system reports it.
struct ReportedBox {
  int track = 0;
  RigidTransform world_from_object;
};

// Returns the reported box in camera 0.
inline ObjectBox BoxOf(const ReportedBox& reported, int frame) {
  const RigidTransform camera_from_object =
      DriveCamera(frame).Inverse() * reported.world_from_object;
  const Eigen::Vector3d forward = camera_from_object.rotation() * Eigen::Vector3d::UnitX();
  ObjectBox box;
  box.frame = frame;
  box.track = reported.track;
  box.type = "Car";
  box.occlusion = 0;
  box.right_px = box.bottom_px = 100.0;
  box.box3d = {1.5, 1.8, 4.0,
               camera_from_object.translation() + Eigen::Vector3d(-kLeftOffset_m, 0.75, 0.0),
               std::atan2(-forward.z(), forward.x())};
  return box;
}

inline std::string Row(const ObjectBox& box) {
  const ObjectBox::Box3d& b = *box.box3d;
  std::ostringstream row;
  row.precision(17);
  row << box.frame << ' ' << box.track << ' ' << box.type << " -1 -1 0 0 0 100 100 " << b.height_m
      << ' ' << b.width_m << ' ' << b.length_m << ' ' << b.bottom_in_camera.x() << ' '
      << b.bottom_in_camera.y() << ' ' << b.bottom_in_camera.z() << ' ' << b.heading_rad << " 1\n";
  return row.str();
}

// Rows of the boxes in the sequence's labels, or as `report` changes them. A box is omitted if
// `report` returns no value.
using ReportBox = std::function<std::optional<ReportedBox>(ReportedBox truth, int frame)>;
inline std::string Rows(const ReportBox& report = [](const ReportedBox& truth, int) {
  return truth;
}) {
  std::string rows;
  for (int frame = 0; frame < kDriveFrames; ++frame) {
    for (const int track : {0, 1}) {
      const auto reported = report({track, CarInWorld(track, frame)}, frame);
      if (reported) rows += Row(BoxOf(*reported, frame));
    }
  }
  return rows;
}

class SystemDrive {
 public:
  SystemDrive() {
    sequence_.name = "drive";
    sequence_.folder = folder_.path();
    sequence_.groundtruth = "official";
    sequence_.left_offset_m = kLeftOffset_m;
    sequence_.total_frames = kDriveFrames;
    for (int frame = 0; frame < kDriveFrames; ++frame) {
      sequence_.images.emplace_back();
      sequence_.timestamps_ns.push_back(100'000'000 * frame);
      sequence_.groundtruth_world_from_camera.emplace_back(DriveCamera(frame));
      for (const int track : {0, 1}) {
        sequence_.labels.push_back(BoxOf({track, CarInWorld(track, frame)}, frame));
      }
    }
  }

  Sequence& sequence() { return sequence_; }
  const TempFolder& folder() const { return folder_; }

  // The true camera trajectory in another world, with timestamps 7 ms late, for the frames of which
  // `has` is true.
  static Trajectory Camera(const std::function<bool(int)>& has = [](int) { return true; }) {
    Trajectory camera;
    for (int frame = 0; frame < kDriveFrames; ++frame) {
      if (has(frame))
        camera.push_back({100'000'000 * frame + 7'000'000, World() * DriveCamera(frame)});
    }
    return camera;
  }
  static RigidTransform World() { return {ExpSo3({0.3, -0.2, 0.1}), {5.0, 6.0, 7.0}}; }

  SystemRequest Request(const std::string& camera, const std::string& rows) const {
    SystemFiles files = {"other", folder_.Write("camera.txt", camera), {}};
    if (rows != "none") files.objects = folder_.Write("tracks.txt", rows);
    return {sequence_, "content", files, 0};
  }
  SystemOutcome Score(const std::string& rows,
                      const std::string& camera = FormatTumTrajectory(Camera())) const {
    return ScoreSystem(Request(camera, rows));
  }

 private:
  TempFolder folder_;
  Sequence sequence_;
};

inline double ValueOf(const SystemOutcome& outcome, const std::string& name) {
  const Metric* metric = FindMetric(outcome.metrics, name);
  return metric == nullptr ? std::nan("") : metric->value;
}

}  // namespace cvo::test
