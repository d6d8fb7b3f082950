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

// The left images that a run was made of.
class RunImages {
 public:
  // `folder`: of the sequence; empty: where the run found it. Throws Error where it is not there
  // any more, or has other frames or another camera.
  RunImages(const reports::OverlayRun& run, const std::string& folder);

  // Grey, counted in the folder. Empty where the image cannot be decoded.
  cv::Mat Left(int frame) const;

 private:
  Sequence sequence_;
};

// Where the boxes of a run were; empty: a level of the scene, or its labels.
struct GivenDetections {
  std::string file = {};
  int camera = -1;  // as SequenceRequest::detections_camera
  double min_score = -1e300;
  std::string labels = {};  // file of the truth of bodies, where it is not in the folder
};

// The sequence of a run with the boxes that it was given; empty where they cannot be told. Throws
// Error for a file that is given and holds others.
std::optional<Sequence> FindDetections(const std::string& folder, const reports::OverlayRun& run,
                                       const GivenDetections& given);

// The sequence of a run with its truth, without detections; empty where it cannot be read.
std::optional<Sequence> FindLabelled(const std::string& folder, const reports::OverlayRun& run,
                                     const std::string& labels_file);

// By frame, of the classes.
std::vector<std::vector<Detection>> DetectionsOf(const Sequence& sequence,
                                                 const std::vector<std::string>& classes);

// All boxes that the run was given in place of those alone that a cluster was associated with,
// where they can be told: of the levels of a scene and of its labels, those with the same hash.
// False where none are.
bool AdoptDetections(const std::string& folder, reports::OverlayRun& run,
                     const GivenDetections& given = {});

}  // namespace cvo
