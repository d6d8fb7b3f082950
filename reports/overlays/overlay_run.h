// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/record/run_summary.h"
#include "reports/runs/run_detail.h"

namespace cvo::reports {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Rgb&) const = default;
};

// The colour of a cluster, the same in every frame, run and report. Every 16th id has the same one.
// The first seven remain distinguishable with red-green colour blindness (after Okabe and Ito).
Rgb ClusterColor(std::int64_t id);

// A pose as stored in result files.
RigidTransform TransformOf(const Pose& pose);

// A cluster as seen in one frame. Points are in the camera frame, in metres.
struct ClusterShape {
  std::int64_t id = 0;
  std::string category;
  bool predicted = false;  // by the motion model alone
  // Corner i is at the positive end of axis k if bit k of i is set.
  std::array<Eigen::Vector3d, 8> corners;
  // Its centre in the last two seconds, oldest first; the last one is that of this frame.
  std::vector<Eigen::Vector3d> tail;
  // Its centre half a second later at its velocity; empty if it hardly moves.
  std::optional<Eigen::Vector3d> next = {};

  const Eigen::Vector3d& center() const { return tail.back(); }
};

// Everything that is drawn on one image.
struct OverlayFrame {
  int frame = 0;        // index within the folder of the sequence
  double time_s = 0.0;  // since the first frame of the run
  std::string status;   // tracking status of the camera
  std::string run;      // "full, seed 1"
  bool has_truth = false;
  std::vector<LabelledLandmark> landmarks;
  std::vector<ClusterShape> clusters;
  std::vector<ImageBox> detections;
  std::vector<ImageBox> truth;  // around what is visible of the true bodies
  double range_m = 10.0;        // of the view from above, the same in all frames of a run
};

// What can be drawn of a run, read from its folder.
struct OverlayRun {
  std::filesystem::path folder;
  std::string variant;
  std::uint64_t seed = 0;
  RunSequence sequence;
  std::vector<std::string> classes;  // detection classes that the run used
  RunDetail detail;
  bool has_truth = false;  // the true bodies of landmarks are known
  LandmarksByFrame landmarks;
  std::map<int, std::vector<ImageBox>> detections;  // by frame; not read from the folder
  std::map<int, std::vector<ImageBox>> truth;       // by frame; not read from the folder
  double range_m = 10.0;                            // ahead, within which clusters mostly are
  std::vector<std::string> missing;                 // what the drawing lacks, one line each
};

// Reads the folder of a run. Throws Error if it holds no run, or one of another schema version. If
// objects.csv or landmarks.csv is missing, damaged or truncated, the run is read without it and
// OverlayRun::missing names the file, and the line of the damage.
OverlayRun ReadOverlayRun(const std::filesystem::path& folder, LandmarkLabel label);

// Marks the landmarks with a wrong label: on a cluster, but not on the body that holds most of its
// landmarks; or static, but on a moving body. Outliers are never wrong. Needs truth.json.
void MarkWrongLabels(OverlayRun& run);

// Assembles what is drawn on a frame of the run. Throws Error, naming the first and last frame of
// the run, if it has no such frame.
OverlayFrame FrameOf(const OverlayRun& run, int frame);

}  // namespace cvo::reports
