// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <opencv2/core/types.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "core/interface/frame.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// What happened to a sequence's boxes in the processed frames.
struct DetectionCounts {
  int given = 0;          // passed to the estimator
  int outside = 0;        // left out: entirely outside the image
  int skipped = 0;        // left out: in frames without images
  int without_depth = 0;  // passed on unmoved although detected in another camera's image
  std::map<std::string, int> other_classes;  // left out: of classes that were not requested
};

// Classes whose boxes count as rigid bodies unless a run lists others: the vehicles of KITTI and
// COCO (people and cyclists deform; DontCare is not a class), and what moves in the shipped scenes.
inline constexpr std::array<std::string_view, 10> kRigidClasses = {
    "Car", "Van", "Truck", "Tram", "Bus", "Ball", "Block", "Chair", "Crate", "Tower"};
std::vector<std::string> RigidClasses();

// Returns the rigid classes, and the other classes of KITTI and of detectors of road users.
std::vector<std::string> KnownClasses();

// Parses a list "A,B,...". Throws Error for a name that is empty or contains characters other than
// letters, digits, "_", "-" and ".".
std::vector<std::string> ParseClasses(const std::string& text);

// Throws Error for a class that no box has and that looks like a misspelt known one.
void CheckClasses(const std::vector<std::string>& classes, const std::vector<ObjectBox>& boxes);

// The camera in whose image boxes were drawn, relative to the left camera read: `offset_m` is
// Sequence::detections_offset_m.
struct BoxCamera {
  StereoCamera left;
  double offset_m = 0.0;
};

// Returns the detections that the estimator is given for a frame, in file order: the boxes of
// `classes` (ignoring case), moved to the left image read (MoveBox) and clipped to it. Adds to
// `counts` what became of the boxes.
std::vector<Detection> DetectionsOfFrame(const std::vector<ObjectBox>& boxes,
                                         const BoxCamera& camera,
                                         const std::vector<StereoFeature>& features,
                                         const std::vector<std::string>& classes,
                                         DetectionCounts& counts);

// Returns the depth (m) of what a box shows: the median of the nearest dense mode of the features
// that were inside the box where it was drawn. 0 if there are fewer than three of them.
double DepthInBox(const ObjectBox& box, const BoxCamera& camera,
                  const std::vector<StereoFeature>& features);

// Returns the detections of each frame of the sequence, in file order.
std::vector<std::vector<ObjectBox>> DetectionsByFrame(const Sequence& sequence);

// Returns the same boxes as they were drawn, whatever their class: regions where the front end
// looks for corners on bodies.
std::vector<std::vector<cv::Rect2d>> BoxesByFrame(const Sequence& sequence);

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

  std::vector<std::string> Names() const;
};

// Returns the switches of these names: "boxes", "labels" and "camera". Throws Error for another.
OracleSwitches OracleOf(const std::vector<std::string>& names);
// Parses "none", or such names separated by commas.
OracleSwitches ParseOracle(const std::string& text);

// Returns the parts of a text between commas; at least one.
std::vector<std::string> AtCommas(const std::string& text);

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
