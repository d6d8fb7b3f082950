// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/interface/frame.h"
#include "experiments/datasets/sequence.h"
#include "reports/overlays/overlay_run.h"

namespace cvo {

// The left images of a run.
class RunImages {
 public:
  // `folder`: of the sequence; empty: where the run found it. Throws Error if the folder no longer
  // exists, lacks frames of the run or has images of another size.
  RunImages(const reports::OverlayRun& run, const std::string& folder);

  // Returns the grey image of a frame, as numbered in the sequence's folder. Empty if the image
  // cannot be decoded.
  cv::Mat Left(int frame) const;

 private:
  Sequence sequence_;
};

// Opens the sequence of a run, in `folder` or, if that is empty, where the run found it, with the
// detections that the run was given: those of the file that the run read, of a detector level of
// the scene or of the labels, whichever has the hash in the result. Empty if none of them has.
std::optional<Sequence> FindDetections(const std::string& folder, const reports::OverlayRun& run);

// Returns the detections of these classes, by frame. Boxes of another camera stay where they were
// detected, since the depth by which the run moved them is not known.
std::vector<std::vector<Detection>> DetectionsOf(const Sequence& sequence,
                                                 const std::vector<std::string>& classes);

// Adds the detections that FindDetections finds to the run. Returns false if it finds none.
bool AddDetections(const std::string& folder, reports::OverlayRun& run);

}  // namespace cvo
