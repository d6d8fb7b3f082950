// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

// The output of another system for a sequence, in the files that it wrote.
struct SystemFiles {
  std::string name;  // of the system
  // Poses world_from_camera of the left camera read. TUM: timestamps are those of frames to within
  // 20 ms, and frames may be missing. KITTI: one line per frame of the folder, or of the part of it
  // that is read.
  std::filesystem::path camera = {};
  // KITTI tracking rows with 3D boxes in any order, with frames counted from the start of the
  // folder; or a folder of <id>.tum files, world_from_object in the world of `camera`. Empty: none.
  std::filesystem::path objects = {};
  // Number of the first frame that is read in KITTI tracking rows; empty: as in the folder.
  std::optional<int> first_frame = {};
};

struct SystemEstimate {
  ObjectEstimate objects;          // and the camera; without landmarks
  int frames_without_camera = 0;   // of those read
  int object_frames = 0;           // in frames read
  int object_frames_left_out = 0;  // of these: boxes in frames without a camera pose
};

// Reads the files. A box is placed in the world by the camera pose of its frame; the frame of its
// body is at the centre of the box and rotated by its heading. Velocities are differences of
// positions. Throws Error with file and line for what cannot be read, a pose or row of no frame,
// two rows of a track in a frame, a row without a 3D box, and a file without rows.
SystemEstimate ReadSystem(const Sequence& sequence, const SystemFiles& files);

struct SystemRequest {
  const Sequence& sequence;
  std::string content;  // ContentHash of the sequence
  SystemFiles files;
  std::uint64_t seed = 0;       // of the rendered scene, to compare with runs on it
  double right_shift_px = 0.0;  // correction given to the system, not the sequence's own
  std::string images = {};      // ImagesHash of the sequence
  // Identity of the program that is run to write the files; null: they exist.
  Json program = {};
};

struct SystemOutcome : SystemEstimate {
  std::string result = {};           // content of result.json
  std::vector<Metric> metrics = {};  // camera_*, object_*; none that need landmarks
  std::vector<BodyScore> bodies = {};
};

// Returns the identity of what ScoreSystem would do, from the program or the bytes of the files.
// Throws Error for a file that cannot be read.
std::string IdentifySystem(const SystemRequest& request);

// Scores the files against the sequence's ground truth in the same way as runs. Bodies are matched
// by nearness, as the contract of each metric states. Throws Error as ReadSystem does, and naming a
// field that is not finite.
SystemOutcome ScoreSystem(const SystemRequest& request);

}  // namespace cvo
