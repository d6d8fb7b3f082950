// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/record/metric_catalogue.h"

#include <array>
#include <cmath>
#include <map>
#include <string_view>

namespace cvo::reports {
namespace {

using enum MetricId;
using enum MetricFamily;
using enum MetricKind;
using enum FromBody;

using A = Alignment;
using P = Pairing;
using D = Delta;
using S = Aggregation;  // summary

constexpr MetricEntry Entry(MetricId id, MetricFamily family, const char* name, MetricUnit unit,
                            Relation relation, MetricKind kind, FromBody from_body,
                            std::optional<double> BodyRow::*error, const char* label,
                            const char* meaning) {
  const bool of_predictions = error != nullptr;
  return {id,    family,  name, unit,           relation, kind,   from_body,
          error, nullptr, 0.0,  of_predictions, label,    meaning};
}

constexpr MetricEntry Camera(MetricId id, const char* name, MetricUnit unit, MetricKind kind,
                             Relation relation, const char* label, const char* meaning) {
  return Entry(id, kCamera, name, unit, relation, kind, kNothing, nullptr, label, meaning);
}

constexpr MetricEntry Ate(MetricId id, const char* name, Aggregation summary, const char* label,
                          const char* meaning) {
  return Camera(id, name, MetricUnit::kMetres, kError,
                {A::kPositions, P::kFramesWithBoth, D::kNone, summary}, label, meaning);
}

constexpr MetricEntry Landmarks(MetricId id, const char* name, Pairing pairing, Aggregation summary,
                                const char* label, const char* meaning) {
  return Entry(id, kLandmarks, name, MetricUnit::kOne, {A::kNone, pairing, D::kNone, summary},
               kFraction, kNothing, nullptr, label, meaning);
}

constexpr MetricEntry BoxAp(MetricId id, const char* name, Pairing space, Aggregation level,
                            const char* label, const char* meaning) {
  return Entry(id, kBoxes, name, MetricUnit::kOne, {A::kNone, space, D::kNone, level}, kFraction,
               kNothing, nullptr, label, meaning);
}

constexpr MetricEntry Calibration(MetricId id, const char* name, MetricUnit unit,
                                  Aggregation summary, const char* label, const char* meaning) {
  return Entry(id, kCalibration, name, unit, {A::kNone, P::kWholeImage, D::kNone, summary}, kError,
               kNothing, nullptr, label, meaning);
}

constexpr MetricEntry Mean(MetricId id, const char* name, MetricUnit unit, Alignment alignment,
                           Pairing pairing, Delta delta, std::optional<double> BodyRow::*error,
                           const char* label, const char* meaning) {
  const Relation relation = {alignment, pairing, delta, S::kMeanOverBodies};
  return {id,    kBodies, name, unit,  relation, kError, kField,
          error, nullptr, 0.0,  false, label,    meaning};
}

constexpr MetricEntry Success(MetricId id, const char* name, double limit_m, const char* label,
                              const char* meaning) {
  const Relation relation = {A::kWorldAndBody, P::kVisible, D::kNone, S::kFractionWithin};
  return {id,        kBodies,  name,    MetricUnit::kOne, relation,
          kFraction, kSuccess, nullptr, nullptr,          limit_m,
          true,      label,    meaning};
}

constexpr MetricEntry Number(MetricId id, const char* name, Pairing pairing, Aggregation summary,
                             FromBody from_body, int BodyRow::*count, const char* label,
                             const char* meaning) {
  const Relation relation = {A::kNone, pairing, D::kNone, summary};
  return {id,  kBodies, name,  MetricUnit::kOne, relation, kCount, from_body, nullptr, count,
          0.0, false,   label, meaning};
}

// The entry of one of MaxDrifts::Values.
constexpr MetricEntry Drift(MetricId first, std::size_t index, const char* name,
                            const char* label) {
  constexpr std::array kAlignments = {A::kAllPoses, A::kAllMotions, A::kFirstMotions};
  constexpr std::array kMeanings = {
      "Largest error over the run, in position or in an angle, after one constant change of the "
      "estimated frame, over all frames: ClusterVO's protocol.",
      "Largest error over the run, in position or in an angle of the frame where these are "
      "largest, of motions since the first frame: by the tool of Oxford Multimotion.",
      "Largest error over the run, in position or in an angle of the frame where these are "
      "largest, of motions since the first frame, registered by the first 25 frames: MVO's "
      "protocol."};
  const std::size_t contract = index / 4;
  const bool camera = first == kCameraMaxDrift;
  const Aggregation summary = index % 4 == 0  ? S::kMaximumOfTranslations
                              : contract == 0 ? S::kMaximumOfAngle
                                              : S::kAngleOfLargest;
  const Relation relation = {kAlignments[contract], camera ? P::kFramesWithBoth : P::kEstimated,
                             D::kNone, summary};
  return Entry(MaxDriftMetric(first, index), camera ? kCamera : kBodies, name,
               index % 4 == 0 ? MetricUnit::kMetres : MetricUnit::kRadians, relation, kError,
               camera ? kNothing : kMaxDrift, nullptr, label, kMeanings[contract]);
}

constexpr std::array<MetricEntry, kMetricCount> kMetrics = {{
    Camera(kCameraCoverage, "camera_coverage", MetricUnit::kOne, kFraction,
           {A::kNone, P::kFramesWithTruth, D::kNone, S::kFractionOfFrames}, "camera coverage",
           "Fraction of the frames in which the camera has an estimated position."),
    Ate(kCameraAte, "camera_ate", S::kRmsOfPositions, "camera ATE",
        "Absolute trajectory error of the camera: distance between estimated and true positions "
        "after the two trajectories are aligned; root mean square over frames."),
    Ate(kCameraAteMean, "camera_ate_mean", S::kMeanOfPositions, "camera ATE, mean",
        "As camera ATE, but the mean over frames."),
    Ate(kCameraAteMedian, "camera_ate_median", S::kMedianOfPositions, "camera ATE, median",
        "As camera ATE, but the median over frames."),
    Ate(kCameraAteMax, "camera_ate_max", S::kMaximumOfPositions, "camera ATE, maximum",
        "As camera ATE, but the largest."),
    Ate(kCameraAteLateral, "camera_ate_lateral", S::kRmsOfLateral, "camera ATE, lateral",
        "The part of camera ATE to the left or right of the true camera."),
    Ate(kCameraAteVertical, "camera_ate_vertical", S::kRmsOfVertical, "camera ATE, vertical",
        "The part of camera ATE above or below the true camera."),
    Ate(kCameraAteLongitudinal, "camera_ate_longitudinal", S::kRmsOfLongitudinal,
        "camera ATE, longitudinal", "The part of camera ATE along the view."),
    Ate(kCameraAteVelocity, "camera_ate_velocity", S::kRmsOfPositions, "camera ATE, velocities",
        "As camera ATE, but against positions integrated from the measured velocities."),
    Ate(kCameraTruthGap, "camera_truth_gap", S::kRmsOfPositions, "gap of the truths",
        "ATE of positions from velocities against measured ones: less is undecided."),
    Camera(kCameraEndRotation, "camera_end_rotation", MetricUnit::kRadians, kError,
           {A::kNone, P::kFramesWithBoth, D::kNone, S::kAngleAtEnd}, "camera end rotation",
           "Error of the rotation of the camera from the first frame to the last."),
    Camera(kCameraRrpeAllPairs, "camera_rrpe_all_pairs", MetricUnit::kRadians, kError,
           {A::kNone, P::kOrderedPairs, D::kAll, S::kRmsOfAngles}, "camera R.RPE",
           "Relative rotation error of the camera between every two frames of a run."),
    Camera(kCameraTrpeAllPairs, "camera_trpe_all_pairs", MetricUnit::kMetres, kError,
           {A::kNone, P::kOrderedPairs, D::kAll, S::kRmsOfTranslations}, "camera T.RPE",
           "Relative translation error of the camera between every two frames of a run."),
    Camera(kCameraRrpe1Frame, "camera_rrpe_1_frame", MetricUnit::kRadians, kError,
           {A::kNone, P::kConsecutive, D::kOneFrame, S::kRmsOfAngles}, "camera R.RPE/frame",
           "Relative rotation error of the camera from one frame to the next."),
    Camera(kCameraTrpe1Frame, "camera_trpe_1_frame", MetricUnit::kMetres, kError,
           {A::kNone, P::kConsecutive, D::kOneFrame, S::kRmsOfTranslations}, "camera T.RPE/frame",
           "Relative translation error of the camera from one frame to the next."),
    Camera(kCameraTDrift, "camera_t_drift", MetricUnit::kPercent, kError,
           {A::kNone, P::kKittiStretches, D::kKittiLengths, S::kTranslationOverLength}, "t drift",
           "Translation error of the camera over stretches of 100 to 800 m, in percent of their "
           "length, as defined by the KITTI benchmark."),
    Camera(kCameraRDrift, "camera_r_drift", MetricUnit::kDegreesPer100m, kError,
           {A::kNone, P::kKittiStretches, D::kKittiLengths, S::kRotationOverLength}, "r drift",
           "Rotation error of the camera over stretches of 100 to 800 m, per length, as defined by "
           "the KITTI benchmark."),
    Camera(kCameraPathError, "camera_path_error", MetricUnit::kPercent, kError,
           {A::kNone, P::kConsecutive, D::kOneFrame, S::kLengthRatio}, "camera path error",
           "How much longer or shorter the estimated path of the camera is than the true one, in "
           "percent of its length."),
    Drift(kCameraMaxDrift, 0, "camera_max_drift", "camera max drift"),
    Drift(kCameraMaxDrift, 1, "camera_max_drift_roll", "camera max roll"),
    Drift(kCameraMaxDrift, 2, "camera_max_drift_pitch", "camera max pitch"),
    Drift(kCameraMaxDrift, 3, "camera_max_drift_yaw", "camera max yaw"),
    Drift(kCameraMaxDrift, 4, "camera_max_drift_tool", "camera max drift, tool"),
    Drift(kCameraMaxDrift, 5, "camera_max_drift_tool_roll", "camera max roll, tool"),
    Drift(kCameraMaxDrift, 6, "camera_max_drift_tool_pitch", "camera max pitch, tool"),
    Drift(kCameraMaxDrift, 7, "camera_max_drift_tool_yaw", "camera max yaw, tool"),
    Drift(kCameraMaxDrift, 8, "camera_max_drift_first25", "camera max drift, 25 frames"),
    Drift(kCameraMaxDrift, 9, "camera_max_drift_first25_roll", "camera max roll, 25 frames"),
    Drift(kCameraMaxDrift, 10, "camera_max_drift_first25_pitch", "camera max pitch, 25 frames"),
    Drift(kCameraMaxDrift, 11, "camera_max_drift_first25_yaw", "camera max yaw, 25 frames"),
    Entry(kObjectCoverage, kBodies, "object_coverage", MetricUnit::kOne,
          {A::kNone, P::kVisible, D::kNone, S::kFractionEstimated}, kFraction, kCoverage, nullptr,
          "object coverage",
          "Fraction of the frames in which a visible object has an estimate. Errors must be read "
          "together with it: a method that loses difficult objects gets lower errors."),
    Success(kObjectSuccess5cm, "object_success_5cm", 0.05, "within 5 cm",
            "Fraction of all visible object-frames in which the object is within 5 cm of the "
            "truth. Missed objects count as failures."),
    Success(kObjectSuccess10cm, "object_success_10cm", 0.1, "within 10 cm",
            "Fraction of all visible object-frames in which the object is within 10 cm of the "
            "truth. Missed objects count as failures."),
    Success(kObjectSuccess20cm, "object_success_20cm", 0.2, "within 20 cm",
            "Fraction of all visible object-frames in which the object is within 20 cm of the "
            "truth. Missed objects count as failures."),
    Entry(kObjectAte, kBodies, "object_ate", MetricUnit::kMetres,
          {A::kWorldAndBody, P::kEstimated, D::kNone, S::kMeanOverBodies}, kError, kField,
          &BodyRow::ate_m, "object ATE",
          "Absolute trajectory error of moving objects, in the world frame of the camera: objects "
          "are not aligned individually. Computed over the frames that have an estimate."),
    Mean(kObjectRrpeAllPairs, "object_rrpe_all_pairs", MetricUnit::kRadians, A::kWorldAndBody,
         P::kEstimatedPairs, D::kAll, &BodyRow::all_pairs_rad, "object R.RPE",
         "Relative rotation error of objects between every two frames."),
    Mean(kObjectTrpeAllPairs, "object_trpe_all_pairs", MetricUnit::kMetres, A::kWorldAndBody,
         P::kEstimatedPairs, D::kAll, &BodyRow::all_pairs_m, "object T.RPE",
         "Relative translation error of objects between every two frames."),
    Mean(kObjectRrpe1Frame, "object_rrpe_1_frame", MetricUnit::kRadians, A::kWorldAndBody,
         P::kEstimatedConsecutive, D::kOneFrame, &BodyRow::one_frame_rad, "object R.RPE/frame",
         "Relative rotation error of objects from one frame to the next."),
    Mean(kObjectTrpe1Frame, "object_trpe_1_frame", MetricUnit::kMetres, A::kWorldAndBody,
         P::kEstimatedConsecutive, D::kOneFrame, &BodyRow::one_frame_m, "object T.RPE/frame",
         "Relative translation error of objects from one frame to the next."),
    Mean(kObjectMotionR, "object_motion_r", MetricUnit::kRadians, A::kWorld, P::kMotions,
         D::kOneFrame, &BodyRow::motion_rad, "motion error",
         "Error of the rotation of an object from one frame to the next."),
    Mean(kObjectMotionT, "object_motion_t", MetricUnit::kMetres, A::kWorld, P::kMotions,
         D::kOneFrame, &BodyRow::motion_m, "motion error",
         "Error of the translation of an object from one frame to the next."),
    Mean(kObjectAteInCamera, "object_ate_in_camera", MetricUnit::kMetres, A::kSeenAndBody,
         P::kEstimated, D::kNone, &BodyRow::ate_in_camera_m, "object ATE in camera",
         "As object ATE, but objects are compared as the camera of each frame sees them: what "
         "objects add to the error of the camera, and to that of its truth."),
    Mean(kObjectMotionTInCamera, "object_motion_t_in_camera", MetricUnit::kMetres, A::kSeen,
         P::kMotions, D::kOneFrame, &BodyRow::motion_in_camera_m, "motion error in camera",
         "As the motion error in translation, but objects are compared as the camera of each frame "
         "sees them."),
    Mean(kObjectVelocity, "object_velocity", MetricUnit::kMetresPerSecond, A::kWorldAndBody,
         P::kVelocities, D::kCentral, &BodyRow::velocity_m_s, "velocity error",
         "Error of the velocity of objects: length of the difference from the true one."),
    Drift(kObjectMaxDrift, 0, "object_max_drift", "max drift"),
    Drift(kObjectMaxDrift, 1, "object_max_drift_roll", "max roll"),
    Drift(kObjectMaxDrift, 2, "object_max_drift_pitch", "max pitch"),
    Drift(kObjectMaxDrift, 3, "object_max_drift_yaw", "max yaw"),
    Drift(kObjectMaxDrift, 4, "object_max_drift_tool", "max drift, tool"),
    Drift(kObjectMaxDrift, 5, "object_max_drift_tool_roll", "max roll, tool"),
    Drift(kObjectMaxDrift, 6, "object_max_drift_tool_pitch", "max pitch, tool"),
    Drift(kObjectMaxDrift, 7, "object_max_drift_tool_yaw", "max yaw, tool"),
    Drift(kObjectMaxDrift, 8, "object_max_drift_first25", "max drift, 25 frames"),
    Drift(kObjectMaxDrift, 9, "object_max_drift_first25_roll", "max roll, 25 frames"),
    Drift(kObjectMaxDrift, 10, "object_max_drift_first25_pitch", "max pitch, 25 frames"),
    Drift(kObjectMaxDrift, 11, "object_max_drift_first25_yaw", "max yaw, 25 frames"),
    Number(kObjectIdSwitches, "object_id_switches", P::kEachFrameItself, S::kSwitches, kSum,
           &BodyRow::id_switches, "id switches",
           "Number of times a true object is assigned a different id."),
    Number(kObjectFragments, "object_fragments", P::kEachFrameItself, S::kFragments, kSum,
           &BodyRow::fragments, "fragments",
           "Number of times the estimate of an object is interrupted and resumes."),
    Number(kObjectJoins, "object_joins", P::kEstimated, S::kJoins, kSum, &BodyRow::joins, "joins",
           "Number of times a lost object continues under its former id."),
    Number(kObjectWrongJoins, "object_joins_wrong", P::kEstimated, S::kWrongJoins, kSum,
           &BodyRow::wrong_joins, "wrong joins", "Number of joins that are off by over 10 cm."),
    Number(kObjectUnmatched, "object_unmatched", P::kWhole, S::kMissedBodies, kUnmatched, nullptr,
           "missed objects", "Number of true objects without a matching cluster."),
    Entry(kObjectUnmatchedClusters, kClusters, "object_unmatched_clusters", MetricUnit::kOne,
          {A::kNone, P::kWhole, D::kNone, S::kExtraClusters}, kCount, kNothing, nullptr,
          "extra clusters", "Number of clusters without a matching true object."),
    Landmarks(kMovingPrecision, "moving_precision", P::kObservations, S::kMovingOfReported,
              "moving precision", "Fraction of the landmarks labelled as moving that do move."),
    Landmarks(kMovingRecall, "moving_recall", P::kObservations, S::kReportedOfMoving,
              "moving recall", "Fraction of the moving landmarks that are labelled as moving."),
    Landmarks(kClusterPurity, "cluster_purity", P::kObservations, S::kOnBodyOfCluster,
              "cluster purity",
              "Fraction of the landmarks in clusters that lie on the true body of their cluster, "
              "whether it moves or stands."),
    Landmarks(kClusteringIou, "clustering_iou", P::kFramesWithLandmarks, S::kMeanOverlap,
              "clustering IoU",
              "Overlap of the landmarks of a cluster with those of its true object."),
    Landmarks(kClusteringAri, "clustering_ari", P::kFramesWithGroups, S::kMeanRandIndex,
              "clustering ARI",
              "Agreement of clusters and true objects on which landmarks belong together: 1 for "
              "identical groups, 0 for chance level."),
    BoxAp(kBoxApBvEasy, "box_ap_bv_easy", P::kBirdsEyeBoxes, S::kApEasy, "AP bird's view, easy",
          "Average precision of cars' boxes seen from above, at KITTI's level easy."),
    BoxAp(kBoxApBvModerate, "box_ap_bv_moderate", P::kBirdsEyeBoxes, S::kApModerate,
          "AP bird's view, moderate",
          "Average precision of cars' boxes seen from above, at KITTI's level moderate."),
    BoxAp(kBoxApBvHard, "box_ap_bv_hard", P::kBirdsEyeBoxes, S::kApHard, "AP bird's view, hard",
          "Average precision of cars' boxes seen from above, at KITTI's level hard."),
    BoxAp(kBoxAp3dEasy, "box_ap_3d_easy", P::kVolumeBoxes, S::kApEasy, "AP 3D, easy",
          "Average precision of cars' boxes in 3D, at KITTI's level easy."),
    BoxAp(kBoxAp3dModerate, "box_ap_3d_moderate", P::kVolumeBoxes, S::kApModerate,
          "AP 3D, moderate", "Average precision of cars' boxes in 3D, at KITTI's level moderate."),
    BoxAp(kBoxAp3dHard, "box_ap_3d_hard", P::kVolumeBoxes, S::kApHard, "AP 3D, hard",
          "Average precision of cars' boxes in 3D, at KITTI's level hard."),
    Calibration(kCalibrationError, "calibration_error", MetricUnit::kPixels, S::kRmsOfDisparities,
                "calibration error",
                "How far the disparity error that self-calibration found is from that of the "
                "rendered right camera; root mean square over the image."),
    Calibration(kCalibrationNees, "calibration_nees", MetricUnit::kOne, S::kMeanSquareOfClaimed,
                "calibration NEES",
                "Normalised estimation error squared of self-calibration, per coefficient: about 1 "
                "if its errors are as large as it claims, more if they are larger."),
}};

constexpr bool IsGiven(const char* text) { return text != nullptr && *text != '\0'; }

// An incomplete or misplaced entry does not compile.
constexpr bool IsComplete() {
  for (std::size_t i = 0; i < kMetrics.size(); ++i) {
    const MetricEntry& entry = kMetrics[i];
    if (entry.id != static_cast<MetricId>(i) || !IsGiven(entry.name) || !IsGiven(entry.label) ||
        !IsGiven(entry.meaning) || (entry.from_body == kField) != (entry.body_error != nullptr) ||
        (entry.from_body == kSum) != (entry.body_count != nullptr) ||
        (entry.from_body == kSuccess) != (entry.limit_m > 0.0) ||
        (entry.family == kBodies) != (entry.from_body != kNothing)) {
      return false;
    }
  }
  return true;
}
static_assert(IsComplete());

bool HasOneForm(MetricFamily family) {
  return family == kLandmarks || family == kBoxes || family == kCalibration;
}

std::vector<MetricForm> FormsOf(const MetricEntry& entry, bool causal) {
  const bool has_one = HasOneForm(entry.family) || MaxDriftIndex(entry.id);
  if (has_one && causal) return {};
  std::vector<MetricForm> forms = {{entry.id, BodyGroup::kMovers, causal}};
  if (has_one) return forms;
  if (entry.of_predictions) forms.push_back({entry.id, BodyGroup::kPredicted, causal});
  if (entry.family == kBodies) forms.push_back({entry.id, BodyGroup::kStanding, causal});
  return forms;
}

std::vector<MetricForm> AllForms() {
  std::vector<MetricForm> all;
  for (const bool causal : {false, true}) {
    for (const MetricEntry& entry : kMetrics) {
      for (const MetricForm& form : FormsOf(entry, causal)) all.push_back(form);
    }
  }
  return all;
}

}  // namespace

double MetricEntry::Resolution(double value) const {
  switch (kind) {
    case kError:
      return 0.01 * std::abs(value);
    case kFraction:
      return 0.01;
    case kCount:
      return 1.0;
  }
  return 0.0;
}

const MetricEntry& EntryOf(MetricId id) { return kMetrics[static_cast<std::size_t>(id)]; }

std::string MetricName(const MetricForm& form) {
  std::string name = EntryOf(form.id).name;
  std::string_view group;
  if (form.bodies == BodyGroup::kStanding) group = "standing_";
  if (form.bodies == BodyGroup::kPredicted) group = "predicted_";
  return name.insert(name.find('_') + 1, std::string(form.causal ? "causal_" : "").append(group));
}

std::optional<MetricForm> FindForm(const std::string& name) {
  static const std::map<std::string, MetricForm> forms = [] {
    std::map<std::string, MetricForm> by_name;
    for (const MetricForm& form : AllForms()) by_name[MetricName(form)] = form;
    return by_name;
  }();
  const auto found = forms.find(name);
  return found == forms.end() ? std::nullopt : std::optional(found->second);
}

Contract RelationOf(const MetricForm& form) {
  const MetricEntry& entry = EntryOf(form.id);
  Contract contract;
  contract.alignment = entry.relation.alignment;
  contract.pairing = form.bodies == BodyGroup::kPredicted ? P::kPredicted : entry.relation.pairing;
  contract.delta = entry.relation.delta;
  contract.aggregation = entry.relation.aggregation;
  if (entry.from_body == kSuccess) contract.limit_m = entry.limit_m;
  return contract;
}

std::vector<std::string> AllMetricNames() {
  std::vector<std::string> names;
  for (const MetricForm& form : AllForms()) names.push_back(MetricName(form));
  return names;
}

const MetricEntry* FindEntry(const std::string& name) {
  const std::optional<MetricForm> form = FindForm(name);
  return form ? &EntryOf(form->id) : nullptr;
}

std::string MetricLabel(const std::string& name) {
  const std::optional<MetricForm> form = FindForm(name);
  if (!form) return name;
  std::string label = form->causal ? "causal " : "";
  if (form->bodies == BodyGroup::kStanding) label += "standing ";
  if (form->bodies == BodyGroup::kPredicted) label += "predicted ";
  return label + EntryOf(form->id).label;
}

std::string CoverageOf(const std::string& name) {
  std::optional<MetricForm> form = FindForm(name);
  if (!form || HasOneForm(EntryOf(form->id).family)) return "";
  form->id = EntryOf(form->id).family == kCamera ? kCameraCoverage : kObjectCoverage;
  if (form->bodies == BodyGroup::kPredicted) form->bodies = BodyGroup::kMovers;
  return MetricName(*form);
}

}  // namespace cvo::reports
