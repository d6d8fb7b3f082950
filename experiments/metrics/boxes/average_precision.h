// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/json/json_record.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

// Whether the box is of this KITTI class, ignoring case.
bool IsOfClass(const ObjectBox& box, const std::string& category);

// Whether the box is of a class so similar to `category` that matching a detection to it is not
// penalised: vans for cars, sitting persons for pedestrians (tracking files call them "Person").
bool IsNeighbour(const ObjectBox& box, const std::string& category);

// Whether the label marks a region in which objects were not labelled.
bool IsDontCare(const ObjectBox& label);

// The space in which the overlap of two boxes is measured: the image, the ground plane (x-z of
// rectified camera 0), or 3D.
enum class BoxSpace { kImage, kBirdsEye, kVolume };
constexpr std::array<const char*, 3> EnumNames(BoxSpace) { return {"2d", "bv", "3d"}; }

// Intersection over union, in [0, 1]; 0 if a box has no extent in that space. On the ground plane,
// boxes are rectangles of length x width rotated by their heading. Their height extends upwards
// (-y) from the centre of the bottom face.
double IntersectionOverUnion(BoxSpace space, const ObjectBox& a, const ObjectBox& b);

// Intersection in the image over the area of `detection`, in [0, 1].
double ShareInside(const ObjectBox& detection, const ObjectBox& region);

enum class ApLevel { kEasy, kModerate, kHard };
constexpr std::array<const char*, 3> EnumNames(ApLevel) { return {"easy", "moderate", "hard"}; }

// Whether the devkit's limits on truncation (0.15, 0.30, 0.50) are applied. The truncation of a
// label is a fraction in object files, but 0, 1 or 2 in tracking files, where the limits therefore
// ignore every truncated box.
enum class TruncationRule { kApplied, kIgnored };
constexpr std::array<const char*, 2> EnumNames(TruncationRule) { return {"applied", "ignored"}; }

// What two values of average precision must have in common to be comparable. The rules are those of
// the KITTI object devkit (cpp/evaluate_object.cpp), by which DontCare regions, having no 3D box,
// excuse false positives in the image only. One rule differs: the devkit takes each score for one
// recall point, so that 10 labels found without a fault get 3/11; of fewer than 41 labels, we take
// a score for each point that it reaches. The fields are the choices in which published values
// differ.
struct ApProtocol {
  std::string category = "Car";
  BoxSpace space = BoxSpace::kImage;
  double least_overlap = 0.7;  // must be exceeded
  TruncationRule truncation = TruncationRule::kApplied;

  bool operator==(const ApProtocol&) const = default;
};

// Labels and detections of one image. A detection without a score is ranked as if its score were 1.
struct ApFrame {
  std::vector<ObjectBox> labels;
  std::vector<ObjectBox> detections;
};

inline constexpr std::size_t kRecallSlots = 41;

struct AveragePrecision {
  ApLevel level = ApLevel::kEasy;
  double ap11 = 0.0;  // mean over recall 0, 0.1, ..., 1; in [0, 1]
  double ap40 = 0.0;  // mean over recall 1/40, 2/40, ..., 1: the benchmark's since October 2019
  int valid_labels = 0;
  // [i]: the highest precision at recall i/40 or above; 0 beyond the highest recall reached.
  std::array<double, kRecallSlots> precision = {};
};

// Evaluates all three levels. Frames without detections count: their labels are missed.
std::array<AveragePrecision, 3> EvaluateAp(const std::vector<ApFrame>& frames,
                                           const ApProtocol& protocol);

// Reads labels and detections of the frames of `range`. For KITTI tracking, these are two files,
// and the frames are those with a box in either; for KITTI object, they are two folders of
// <number>.txt, and the frames are those of the label files. Throws Error if a file cannot be read,
// if an image has a detection file but no label file, or for a track that a frame has twice if
// `tracks` are scored.
std::vector<ApFrame> ReadApFrames(const std::filesystem::path& labels,
                                  const std::filesystem::path& detections, const FrameRange& range,
                                  bool tracks = false);

// Throws Error if only some of the detections, which come from `where`, have a score: without any,
// all thresholds are equal; with some, the ranking would be meaningless.
void CheckScores(const std::vector<ApFrame>& frames, const std::string& where);

// Whether the sequence has a label of a car with a 3D box, without which there are no BoxMetrics.
bool TellsBoxes(const Sequence& sequence);

// Computes box_ap_*: the average precision of the cars among a run's boxes, at an overlap of 0.25
// as in the paper and with labels interpreted as the devkit does. Empty if no label is a car with a
// 3D box; a level without labels is left out.
std::vector<Metric> BoxMetrics(const Sequence& sequence, const std::vector<ObjectBox>& boxes);

}  // namespace cvo
