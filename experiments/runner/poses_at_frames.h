// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

// The poses of a TUM file at the frames of the sequence, by their times to within 20 ms; empty
// where the file has none. Those before and after the part of a folder that is read are passed
// over; any other that is of no frame throws Error with file and line.
OptionalPoses ReadTumAtFrames(const std::filesystem::path& path, const Sequence& sequence);

// The same, or of a KITTI file with one line per frame of the folder or of the part that is read.
// Throws Error also where fewer than two frames have a pose.
OptionalPoses ReadCameraAtFrames(const std::filesystem::path& path, const Sequence& sequence);

}  // namespace cvo
