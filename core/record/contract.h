// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/files/json/json_record.h"

// A contract states what a number means. Two numbers are comparable if their contracts are equal;
// the texts made from contracts are for readers only. Files store the names below.
namespace cvo::reports {

enum class MetricUnit {
  kOne,
  kMetres,
  kRadians,
  kMetresPerSecond,
  kPercent,
  kDegreesPer100m,
  kMs,
  kPixels
};
constexpr std::array<const char*, 8> EnumNames(MetricUnit) {
  return {"1", "m", "rad", "m/s", "%", "deg/100 m", "ms", "px"};
}

// What is measured.
enum class Subject { kCamera, kMovers, kStanding, kClusters, kLandmarks, kCars, kStereo };
constexpr std::array<const char*, 7> EnumNames(Subject) {
  return {"left camera", "bodies that move",  "bodies that stay put", "clusters", "landmarks",
          "cars",        "stereo calibration"};
}

enum class PoseTime { kRefined, kCausal, kFile };
constexpr std::array<const char*, 3> EnumNames(PoseTime) { return {"refined", "causal", "file"}; }

enum class TruthSource { kNone, kDevkit, kVelocities, kOfficial, kFile, kScene, kLabels };
constexpr std::array<const char*, 7> EnumNames(TruthSource) {
  return {"none",
          "devkit",
          "devkit, positions by its velocities",
          "official",
          "file",
          "rendered scene",
          "labels with 3D boxes"};
}

// How a body is judged to be visible well enough: by the pixels of its mask and the unoccluded
// percentage of it; by the height in pixels and the occlusion level of its label; by its centre
// being in the image; or by the number of its labelled landmarks in the image.
enum class VisibleBy { kMask, kLabel, kCentre, kLandmarks };
constexpr std::array<const char*, 4> EnumNames(VisibleBy) {
  return {"mask", "label", "centre", "landmarks"};
}
struct Visibility {
  VisibleBy by = VisibleBy::kMask;
  int least_px = 0;
  int limit = 0;  // minimum percentage, maximum occlusion, or minimum landmarks

  bool operator==(const Visibility&) const = default;
  CVO_FIELDS(by, least_px, limit);
};

enum class Alignment {
  kNone,
  kPositions,
  kWorld,
  kWorldAndBody,
  kSeen,
  kSeenAndBody,
  kAllPoses,
  kAllMotions,
  kFirstMotions
};
constexpr std::array<const char*, 9> EnumNames(Alignment) {
  return {
      "none",
      "SE(3) over positions, Umeyama without scale",
      "world by the camera (chordal mean of orientations, mean of positions)",
      "world by the camera (chordal mean of orientations, mean of positions), one "
      "object_from_gtobject per body in closed form over its frames",
      "each true pose as the camera of its frame sees it, from where that camera was estimated",
      "each true pose as the camera of its frame sees it, from where that camera was estimated; "
      "one object_from_gtobject per body in closed form over its frames",
      "one rigid transform on the right of the estimated poses over all frames, as ClusterVO; "
      "ours: in closed form, world by the first pose of the camera",
      "one rigid transform between the moving frames by their motions since the first frame, "
      "as the tool of Oxford Multimotion; ours: squared errors in the frame of the truth",
      "one rigid transform between the moving frames by their motions since the first frame "
      "up to the 25th, as MVO 2018; ours: squared errors in the frame of the truth"};
}

// Which frames or pairs of frames are compared. Frames of a body are those in which it is visible
// and its estimate counts.
enum class Pairing {
  kFramesWithTruth,
  kFramesWithBoth,
  kOrderedPairs,
  kConsecutive,
  kKittiStretches,
  kVisible,
  kEstimated,
  kEstimatedPairs,
  kEstimatedConsecutive,
  kMotions,
  kVelocities,
  kEachFrameItself,
  kPredicted,
  kWhole,
  kObservations,
  kFramesWithLandmarks,
  kFramesWithGroups,
  kBirdsEyeBoxes,
  kVolumeBoxes,
  kVelocitiesOfPositions,
  kWholeImage
};
constexpr std::array<const char*, 21> EnumNames(Pairing) {
  return {
      "all frames with truth",
      "all frames with truth and estimate",
      "all ordered pairs i != j of frames with truth and estimate",
      "consecutive frames with truth and estimate",
      "KITTI devkit sub-sequences that start at every 10th frame",
      "all visible object-frames",
      "visible object-frames with an estimate",
      "all ordered pairs i != j of visible object-frames with an estimate",
      "consecutive visible object-frames with an estimate",
      "consecutive visible object-frames with an estimate; E = G_k^-1 H_gt^-1 H_est G_k with the "
      "motion H = P_k+1 P_k^-1 in world",
      "visible object-frames with an estimate, against differences of true positions of the same "
      "point",
      "all visible object-frames, the cluster of a body in each by itself",
      "object-frames, visible or not, where the pose is predicted or too few landmarks are "
      "observed",
      "bodies and clusters that have an estimate in some frame, one-to-one",
      "each landmark in each frame it is observed in",
      "all frames with such landmarks",
      "frames with landmarks of at least two of the static scene and the bodies",
      "boxes with an intersection over union above 0.25 in bird's view, by KITTI's object devkit",
      "boxes with an intersection over union above 0.25 in 3D, by KITTI's object devkit",
      "visible object-frames with an estimate, differences of estimated positions against "
      "differences of true positions of the same point",
      "disparity error of the last frame against the rendered one, over the whole image"};
}

// How clusters are matched to bodies.
enum class Matching { kLandmarks, kNearness };
constexpr std::array<const char*, 2> EnumNames(Matching) { return {"landmarks", "nearness"}; }

enum class Delta { kNone, kAll, kOneFrame, kKittiLengths, kCentral };
constexpr std::array<const char*, 5> EnumNames(Delta) {
  return {"none", "all", "1 frame", "100, 200, ..., 800 m of the true path",
          "central difference, one-sided where the truth begins or ends"};
}

enum class Aggregation {
  kFractionOfFrames,
  kRmsOfPositions,
  kMeanOfPositions,
  kMedianOfPositions,
  kMaximumOfPositions,
  kRmsOfLateral,
  kRmsOfVertical,
  kRmsOfLongitudinal,
  kAngleAtEnd,
  kMaximumOfTranslations,
  kMaximumOfAngle,
  kAngleOfLargest,
  kRmsOfAngles,
  kRmsOfTranslations,
  kTranslationOverLength,
  kRotationOverLength,
  kFractionEstimated,
  kFractionWithin,
  kMeanOverBodies,
  kSwitches,
  kFragments,
  kJoins,
  kWrongJoins,
  kMissedBodies,
  kExtraClusters,
  kMovingOfReported,
  kReportedOfMoving,
  kOnBodyOfCluster,
  kMeanOverlap,
  kMeanRandIndex,
  kApEasy,
  kApModerate,
  kApHard,
  kLengthRatio,
  kRmsOfDisparities,
  kMeanSquareOfClaimed
};
constexpr std::array<const char*, 36> EnumNames(Aggregation) {
  return {
      "fraction with an estimate",
      "root mean square of position errors",
      "mean of position errors",
      "median of position errors",
      "maximum of position errors",
      "root mean square of position errors along x of the true camera",
      "root mean square of position errors along y of the true camera",
      "root mean square of position errors along z of the true camera",
      "rotation angle of the motion from the first to the last frame",
      "maximum of translation errors; of several bodies their mean",
      "maximum of the absolute angle; of several bodies their mean",
      "absolute angle in the frame where roll, pitch and yaw are largest together; of several "
      "bodies their mean",
      "root mean square of rotation angles",
      "root mean square of translation norms",
      "mean of translation errors over length",
      "mean of rotation errors over length",
      "fraction of object-frames with an estimate; one without an estimate has none",
      "fraction of object-frames with a position error within the limit; one without an estimate "
      "has none",
      "root mean square per body, mean over bodies",
      "number of times a body's cluster is another than the last one",
      "number of times a body has a cluster again after visible frames without one",
      "number of times the cluster matched to a body returns after more than 2 frames",
      "number of times the centre of the body is more than 0.1 m elsewhere in the frame of its "
      "cluster after than before more than 2 frames without it",
      "number of bodies matched to no cluster",
      "number of clusters matched to no body",
      "fraction that is moving of those in a cluster other than the static scene, all frames "
      "together",
      "fraction in a cluster other than the static scene of those that are moving, all frames "
      "together",
      "fraction on the body that most landmarks of their cluster in all frames lie on of those in "
      "a cluster other than the static scene, standing bodies included",
      "intersection over union per body and its matched cluster (the static scene is one, a body "
      "without a cluster has 0), mean over those seen in the frame, mean over frames",
      "adjusted Rand index per frame, a landmark of no cluster alone; mean over frames",
      "average precision at 11 recall points, level easy; labels of any truncation are left out",
      "average precision at 11 recall points, level moderate; labels of any truncation are left "
      "out",
      "average precision at 11 recall points, level hard; labels of any truncation are left out",
      "difference of estimated and true length of the path, over the true one",
      "root mean square of the differences",
      "squared error of the six coefficients by their claimed covariance, over six"};
}

// A range of frames of the sequence, including the last one. kFramesOfRun stands for the range of
// each run, if a whole column shares the contract.
struct FrameSpan {
  int first = 0;
  int last = 0;

  bool operator==(const FrameSpan&) const = default;
  CVO_FIELDS(first, last);
};
inline constexpr FrameSpan kFramesOfRun = {0, -1};

// A field has no value if the source does not state it or the metric has no use for it.
struct Contract {
  std::optional<Subject> subject;
  std::optional<double> travel_m;    // distance above which bodies or landmarks are moving
  std::optional<int> travel_frames;  // frames within which landmarks must travel it
  std::optional<PoseTime> poses;
  std::optional<TruthSource> truth;
  std::optional<TruthSource> camera_truth;  // if labels are placed by the poses of the camera
  std::optional<Visibility> visible;
  std::optional<double> right_shift_px;  // correction of the published calibration; 0: none
  std::optional<Alignment> alignment;
  std::optional<Pairing> pairing;
  std::optional<Matching> matching;
  std::optional<int> least_landmarks;  // minimum observed for an estimate to count
  std::optional<FrameSpan> frames;
  std::optional<Delta> delta;
  std::optional<Aggregation> aggregation;
  std::optional<double> limit_m;

  bool operator==(const Contract&) const = default;
  CVO_RECORD(CVO_OPTIONAL(subject, travel_m, travel_frames, poses, truth, camera_truth, visible,
                          right_shift_px, alignment, pairing, matching, least_landmarks, frames,
                          delta, aggregation, limit_m));
};

// Returns what must be equal for numbers of different runs to form one column. Truth and correction
// belong to a row, because each dataset has its own, and are removed. Frames that are those of the
// run become kFramesOfRun.
Contract ColumnContract(const Contract& contract, const FrameSpan& run);
// Returns the contract with the truth and correction of another.
Contract WithTruthOf(Contract contract, const Contract& other);

// Returns the first field in which the two differ; empty if there is none. A field with a value
// differs from one without.
std::string FirstDifference(const Contract& a, const Contract& b);
// Returns the first field that both state, with different values; empty if there is none.
std::string ContradictingField(const Contract& a, const Contract& b);
// Returns the fields that `wanted` states and `contract` does not.
std::vector<std::string> UnstatedFields(const Contract& contract, const Contract& wanted);
// Returns a field as stored in files, a string without its quotes; empty if it is not stated.
std::string FieldText(const Contract& contract, const std::string& field);

// Returns a contract in words, by topic: aggregation, pairing, delta, alignment, poses, frame,
// truth, correction. Topics that are not stated, or "none", are omitted.
std::vector<std::pair<std::string, std::string>> ContractTexts(const Contract& contract);

// Returns the truth in words, such as "devkit" or "rendered scene; visible: at least 400 px of its
// mask and 30 % unoccluded".
std::string TruthText(const Contract& contract);

// Returns the correction in words, such as "u_right shifted by 0.16 px"; empty if the calibration
// is as published.
std::string CorrectionText(const Contract& contract);

// Returns delta and alignment for the titles of figures, such as "delta all, not aligned".
std::string RelationText(const Contract& contract);

}  // namespace cvo::reports
