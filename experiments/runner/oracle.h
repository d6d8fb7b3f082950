// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/interface/frame.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// By frame from the first one run: ids of bodies and what is seen of them in the left image.
using TrueBoxes = std::vector<std::vector<std::pair<int, ImageBox>>>;

// Around the visible part of bodies of a rendered scene, else those of the labels; those of other
// bodies are not there. Throws Error for a file that cannot be read.
TrueBoxes BoxesOfBodies(const Sequence& sequence, const BodyTruthReader& truth);

// What the estimator is given from the ground truth in place of what it would find out: whose box
// each detection is, which body each feature is on, where the camera is.
struct OracleSwitches {
  bool boxes = false;
  bool labels = false;
  bool camera = false;

  bool any() const { return boxes || labels || camera; }
  std::vector<std::string> Names() const;
};

// Any of "boxes,labels,camera" with commas between, or "none". Throws Error for another name.
OracleSwitches ParseOracle(const std::string& text);

// Which body each detection shows: pairs of an intersection over union of at least 0.5, one-to-one,
// as many as can be and then of the largest sum. Invalid: none.
std::vector<BodyId> BodiesOfDetections(const std::vector<Detection>& detections,
                                       const std::vector<std::pair<int, ImageBox>>& true_boxes);

// The true body at each feature, -1 where it is not known. Frames count from the first one run.
std::vector<LandmarkTruth> TruthOfFeatures(int frame, const std::vector<StereoFeature>& features,
                                           const StereoCamera& camera, BodyTruthReader& truth);

class Oracle {
 public:
  // Throws Error where the sequence lacks the truth that is asked for. `truth` may be null.
  Oracle(const Sequence& sequence, const OracleSwitches& switches, const BodyTruthReader* truth);

  // Fills frame.given. `feature_truth`: TruthOfFeatures, needed for labels alone.
  void Give(int frame_index, const std::vector<LandmarkTruth>& feature_truth,
            StereoFrame& frame) const;

 private:
  OracleSwitches switches_;
  TrueBoxes boxes_;
  std::vector<std::optional<RigidTransform>> first_from_camera_;  // [frame]
};

}  // namespace cvo
