// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <opencv2/core/types.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/stereo_camera.h"
#include "core/interface/frame.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/run_result.h"

namespace cvo {

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

}  // namespace cvo
