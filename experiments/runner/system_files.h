// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_estimate.h"

namespace cvo {

// What another system made of a sequence, as it wrote it.
struct SystemFiles {
  std::string name;  // of the system
  // World from the left camera read. TUM: times are those of frames to within 20 ms, frames may be
  // missing. KITTI: one line per frame of the folder, or of the part of it that is read.
  std::filesystem::path camera;
  // KITTI tracking rows with 3D boxes, frames counted in the folder, in any order; or a folder of
  // <id>.tum, world from object, in the world of `camera`. Empty: none.
  std::filesystem::path objects;
};

struct SystemEstimate {
  ObjectEstimate objects;          // and the camera; without landmarks
  int frames_without_camera = 0;   // of those read
  int object_frames = 0;           // in frames read
  int object_frames_left_out = 0;  // of these: boxes in frames without a camera
};

// A box is placed in the world by its frame's camera; the frame of its body is in the middle of it
// and turned by its heading. Velocities are differences of positions. Throws Error with file and
// line: what cannot be read, a pose or row of no frame, two rows of a track in a frame, a row
// without a 3D box, a file without rows.
SystemEstimate ReadSystem(const Sequence& sequence, const SystemFiles& files);

}  // namespace cvo
