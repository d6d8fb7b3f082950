// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/record/body_row.h"
#include "core/record/contract.h"

namespace cvo::reports {

// The metrics, in the order of results. Each has one entry in metric_catalogue.cc, which holds
// everything that programs and readers are told about it. The function in experiments/metrics that
// computes it refers to the enumerator.
enum class MetricId {
  kCameraCoverage,
  kCameraAte,
  kCameraAteMean,
  kCameraAteMedian,
  kCameraAteMax,
  kCameraAteLateral,
  kCameraAteVertical,
  kCameraAteLongitudinal,
  kCameraAteVelocity,
  kCameraTruthGap,
  kCameraEndRotation,
  kCameraRrpeAllPairs,
  kCameraTrpeAllPairs,
  kCameraRrpe1Frame,
  kCameraTrpe1Frame,
  kCameraTDrift,
  kCameraRDrift,
  kCameraPathError,
  kCameraMaxDrift,  // first of twelve, see MaxDrifts::Values
  kCameraMaxDriftEnd = kCameraMaxDrift + 11,
  kObjectCoverage,
  kObjectSuccess5cm,
  kObjectSuccess10cm,
  kObjectSuccess20cm,
  kObjectAte,
  kObjectRrpeAllPairs,
  kObjectTrpeAllPairs,
  kObjectRrpe1Frame,
  kObjectTrpe1Frame,
  kObjectMotionR,
  kObjectMotionT,
  kObjectAteInCamera,
  kObjectMotionTInCamera,
  kObjectVelocity,
  kObjectMaxDrift,  // first of twelve
  kObjectMaxDriftEnd = kObjectMaxDrift + 11,
  kObjectIdSwitches,
  kObjectFragments,
  kObjectJoins,
  kObjectWrongJoins,
  kObjectUnmatched,
  kObjectUnmatchedClusters,
  kMovingPrecision,
  kMovingRecall,
  kClusterPurity,
  kClusteringIou,
  kClusteringAri,
  kBoxApBvEasy,
  kBoxApBvModerate,
  kBoxApBvHard,
  kBoxAp3dEasy,
  kBoxAp3dModerate,
  kBoxAp3dHard,
  kCalibrationError,
  kCalibrationNees,
};
inline constexpr std::size_t kMetricCount =
    static_cast<std::size_t>(MetricId::kCalibrationNees) + 1;

// The subject of a metric, which determines what computes it and which forms it has.
enum class MetricFamily {
  kCamera,       // camera_metrics: refined and causal
  kBodies,       // object_metrics: refined and causal, of movers and of bodies that stay put
  kClusters,     // object_metrics: refined and causal
  kLandmarks,    // clustering_metrics: one form
  kBoxes,        // box_metrics: one form
  kCalibration,  // calibration_metrics: one form
};

// Kind of value. For fractions higher is better, for the others lower.
enum class MetricKind { kError, kFraction, kCount };

// How the value of a run is computed from its bodies, for means over the bodies of several runs.
enum class FromBody {
  kNothing,    // not computed from bodies
  kField,      // mean of a field of the body's row in the result
  kCoverage,   // fraction of visible frames that are estimated
  kSuccess,    // fraction of visible frames within a limit
  kSum,        // sum of a field
  kMaxDrift,   // mean of one of MaxDrifts
  kUnmatched,  // number of bodies without a cluster
};

// What the function of a metric computes, as its contract states it.
struct Relation {
  Alignment alignment;
  Pairing pairing;
  Delta delta;
  Aggregation aggregation;
};

struct MetricEntry {
  MetricId id;
  MetricFamily family;
  const char* name;  // of its form for refined poses and moving bodies
  MetricUnit unit;
  Relation relation;
  MetricKind kind;
  FromBody from_body;
  std::optional<double> BodyRow::*body_error;  // for kField
  int BodyRow::*body_count;                    // for kSum
  double limit_m;                              // for kSuccess
  bool of_predictions;                         // also has a form for bodies whose pose is predicted
  const char* label;                           // heads its column
  const char* meaning;                         // explains it to readers who do not know it

  bool higher_is_better() const { return kind == MetricKind::kFraction; }
  // Returns the smallest difference worth reporting at a value: a hundredth of an error, 0.01 of a
  // fraction, one event.
  double Resolution(double value) const;
};

const MetricEntry& EntryOf(MetricId id);

// Convert between a max-drift metric and its index in MaxDrifts::Values. `first` is kCameraMaxDrift
// or kObjectMaxDrift; the index is empty for other metrics.
constexpr MetricId MaxDriftMetric(MetricId first, std::size_t index) {
  return static_cast<MetricId>(static_cast<std::size_t>(first) + index);
}
constexpr std::optional<std::size_t> MaxDriftIndex(MetricId id) {
  for (const MetricId first : {MetricId::kCameraMaxDrift, MetricId::kObjectMaxDrift}) {
    if (id >= first && id <= MaxDriftMetric(first, 11)) {
      return static_cast<std::size_t>(id) - static_cast<std::size_t>(first);
    }
  }
  return std::nullopt;
}

enum class BodyGroup { kMovers, kStanding, kPredicted };

// One form of a metric, named like "object_causal_standing_ate".
struct MetricForm {
  MetricId id = MetricId::kCameraAte;
  BodyGroup bodies = BodyGroup::kMovers;
  bool causal = false;  // poses as estimated when their frame arrived
};
std::string MetricName(const MetricForm& form);
// Empty if no form has this name.
std::optional<MetricForm> FindForm(const std::string& name);

// Returns the part of its contract that is the same for every run.
Contract RelationOf(const MetricForm& form);

// Returns the names of all forms.
std::vector<std::string> AllMetricNames();

// Returns the entry of any form; nullptr if no form has this name.
const MetricEntry* FindEntry(const std::string& name);

// Returns the heading of its column, such as "object ATE" or "causal object ATE", or an unknown
// name as it is.
std::string MetricLabel(const std::string& name);

// Returns the coverage that a metric must be read with, such as "object_coverage" for "object_ate";
// empty for metrics of landmarks and of KITTI boxes, and for unknown names.
std::string CoverageOf(const std::string& name);

}  // namespace cvo::reports
