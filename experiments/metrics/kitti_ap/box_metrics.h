// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/kitti_ap/average_precision.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

// Reads labels and detections of the frames of `range`. For KITTI tracking, these are two files;
// their frames are 0 to the last one in either. For KITTI object, they are two folders of
// <number>.txt; the frames are those of the label files. Throws Error if a file cannot be read, if
// an image has a detection file but no label file, or if only some of the detections have a score.
std::vector<ApFrame> ReadApFrames(const std::filesystem::path& labels,
                                  const std::filesystem::path& detections, const FrameRange& range);

// Whether the sequence has a label of a car with a 3D box, without which there are no BoxMetrics.
bool TellsBoxes(const Sequence& sequence);

// Computes box_ap_*: the average precision of the cars among a run's boxes, at an overlap of 0.25
// as in the paper and with labels interpreted as the devkit does. Empty if no label is a car with a
// 3D box; a level without labels is left out.
std::vector<Metric> BoxMetrics(const Sequence& sequence, const std::vector<ObjectBox>& boxes);

}  // namespace cvo
