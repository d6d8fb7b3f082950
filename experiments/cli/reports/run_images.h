// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>

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

// All boxes that the run was given in place of those alone that a cluster was associated with,
// where they can be told: of the levels of a scene and of its labels, those with the same hash.
// False where none are.
bool AdoptDetections(const std::string& folder, reports::OverlayRun& run);

}  // namespace cvo
