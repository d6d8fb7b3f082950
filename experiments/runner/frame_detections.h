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
#include "experiments/log/run_record.h"

namespace cvo {

// Classes whose boxes count as rigid bodies unless a run lists others: KITTI's and COCO's vehicles
// (people and cyclists deform; DontCare is no class), and what moves in the shipped scenes.
inline constexpr std::array<std::string_view, 10> kRigidClasses = {
    "Car", "Van", "Truck", "Tram", "Bus", "Ball", "Block", "Chair", "Crate", "Tower"};
std::vector<std::string> RigidClasses();

// The same and the others of KITTI and of detectors of road users.
std::vector<std::string> KnownClasses();

// "A,B,..." as a list. Throws Error for an empty name.
std::vector<std::string> ParseClasses(const std::string& text);

// Throws Error for a class that no box has and that is a known one misspelt.
void CheckClasses(const std::vector<std::string>& classes, const std::vector<ObjectBox>& boxes);

// Where boxes were drawn: the left camera read and Sequence::detections_offset_m from it.
struct BoxCamera {
  StereoCamera left;
  double offset_m = 0.0;
};

// What the estimator is given of a frame's boxes, in file order: those of `classes` (letter case
// aside), moved to the left image read (MoveBox) and clipped to it. Counts the rest.
std::vector<Detection> DetectionsOfFrame(const std::vector<ObjectBox>& boxes,
                                         const BoxCamera& camera,
                                         const std::vector<StereoFeature>& features,
                                         const std::vector<std::string>& classes,
                                         DetectionCounts& counts);

// Depth (m) of what a box shows: the median within the nearest dense mode of the features that are
// inside it where it was drawn. 0 where fewer than three are.
double DepthInBox(const ObjectBox& box, const BoxCamera& camera,
                  const std::vector<StereoFeature>& features);

// Boxes frame by frame of the sequence, in file order.
std::vector<std::vector<ObjectBox>> DetectionsByFrame(const Sequence& sequence);

// The same as drawn, whatever they show: where the front end looks for corners of bodies.
std::vector<std::vector<cv::Rect2d>> BoxesByFrame(const Sequence& sequence);

}  // namespace cvo
