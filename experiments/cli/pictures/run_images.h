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

// The sequence of a run with the boxes that it was given: those of the file `given`, else those
// that the run read, a level of the scene, or its labels; empty where none are the run's. Throws
// Error for a file that is given and holds others.
std::optional<Sequence> FindDetections(const std::string& folder, const reports::OverlayRun& run,
                                       const BoxSources& given = {});

// The sequence of a run with its truth, without detections; empty where it cannot be read.
std::optional<Sequence> FindLabelled(const std::string& folder, const reports::OverlayRun& run,
                                     const std::filesystem::path& labels_file);

// By frame, of the classes.
std::vector<std::vector<Detection>> DetectionsOf(const Sequence& sequence,
                                                 const std::vector<std::string>& classes);

// All boxes of FindDetections in place of those alone that a cluster was associated with. False
// where they were not found, or are of another camera.
bool AdoptDetections(const std::optional<Sequence>& sequence, reports::OverlayRun& run);

}  // namespace cvo
