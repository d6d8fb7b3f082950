// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/datasets/frame_range.h"
#include "experiments/metrics/kitti_ap/average_precision.h"

namespace cvo {

// Labels and detections of the frames of `range`: of KITTI tracking, two files, whose frames are 0
// to the last of either; of KITTI object, two folders of <number>.txt, whose frames are those of
// the label files. Throws Error for a file that cannot be read, for a detection file of an image
// without labels, and where a detection lacks the score that others have.
std::vector<ApFrame> ReadApFrames(const std::filesystem::path& labels,
                                  const std::filesystem::path& detections, const FrameRange& range);

}  // namespace cvo
