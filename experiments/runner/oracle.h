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

// [frame, from the first one run]: ids of bodies, each with the box of what is visible of it in the
// left image.
using TrueBoxes = std::vector<std::vector<std::pair<int, ImageBox>>>;

// Returns the boxes around the visible parts of the bodies of a rendered scene, else those of the
// labels; labels of anything but a body of `truth` are omitted. Throws Error for a file that cannot
// be read.
TrueBoxes BoxesOfBodies(const Sequence& sequence, const BodyTruthReader& truth);

// What the estimator is given from the ground truth instead of estimating it: the body of each
// detection (boxes), the body of each feature (labels), and the camera pose.
struct OracleSwitches {
  bool boxes = false;
  bool labels = false;
  bool camera = false;

  bool any() const { return boxes || labels || camera; }
  std::vector<std::string> Names() const;
};

// Parses "none" or any of "boxes", "labels" and "camera", separated by commas. Throws Error for
// another name.
OracleSwitches ParseOracle(const std::string& text);

// Returns the body that each detection shows; invalid if none. Matches one-to-one the pairs with an
// intersection over union of at least 0.5: as many as possible, then with the largest sum.
std::vector<BodyId> BodiesOfDetections(const std::vector<Detection>& detections,
                                       const std::vector<std::pair<int, ImageBox>>& true_boxes);

// Returns the true body at each feature, -1 if it is unknown. Frames are counted from the first one
// run.
std::vector<LandmarkTruth> TruthOfFeatures(int frame, const std::vector<StereoFeature>& features,
                                           const StereoCamera& camera, BodyTruthReader& truth);

class Oracle {
 public:
  // Throws Error if the sequence lacks the ground truth that is requested. `truth` may be null.
  Oracle(const Sequence& sequence, const OracleSwitches& switches, const BodyTruthReader* truth);

  // Fills frame.given. `feature_truth` is the result of TruthOfFeatures, needed only for labels.
  void Give(int frame_index, const std::vector<LandmarkTruth>& feature_truth,
            StereoFrame& frame) const;

 private:
  OracleSwitches switches_;
  TrueBoxes boxes_;
  std::vector<std::optional<RigidTransform>> first_from_camera_;  // [frame]
};

}  // namespace cvo
