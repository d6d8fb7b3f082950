// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/datasets/frame_range.h"
#include "experiments/metrics/kitti_ap/average_precision.h"

namespace cvo {

// Reads labels and detections of the frames of `range`. For KITTI tracking, these are two files;
// their frames are 0 to the last one in either. For KITTI object, they are two folders of
// <number>.txt; the frames are those of the label files. Throws Error if a file cannot be read, if
// an image has a detection file but no label file, or if only some of the detections have a score.
std::vector<ApFrame> ReadApFrames(const std::filesystem::path& labels,
                                  const std::filesystem::path& detections, const FrameRange& range);

}  // namespace cvo
