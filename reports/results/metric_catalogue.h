// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/results/body_row.h"
#include "reports/results/contract.h"

namespace cvo::reports {

// What is measured, in the order of results. Each has one entry in metric_catalogue.cc, which holds
// all that programs and readers are told about it; the function in experiments/metrics that
// computes it names the enumerator.
enum class MetricId {
  kCameraCoverage,
  kCameraAte,
  kCameraAteMean,
  kCameraAteMedian,
  kCameraAteMax,
  kCameraRrpeAllPairs,
  kCameraTrpeAllPairs,
  kCameraRrpe1Frame,
  kCameraTrpe1Frame,
  kCameraTDrift,
  kCameraRDrift,
  kCameraMaxDrift,  // twelve, see MaxDrifts::Values
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
  kObjectMaxDrift,  // twelve
  kObjectMaxDriftEnd = kObjectMaxDrift + 11,
  kObjectIdSwitches,
  kObjectFragments,
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
};
inline constexpr std::size_t kMetricCount = static_cast<std::size_t>(MetricId::kBoxAp3dHard) + 1;

// Whose metric it is, which says what computes it and which forms it has.
enum class MetricFamily {
  kCamera,     // camera_metrics: refined and causal
  kBodies,     // object_metrics: refined and causal, of movers and of bodies that stay put
  kClusters,   // object_metrics: refined and causal
  kLandmarks,  // clustering_metrics: one form
  kBoxes,      // box_metrics: one form
};

// What kind of figure it is. Fractions are better where they are higher, the others where lower.
enum class MetricKind { kError, kFraction, kCount };

// How the figure of a run is made of its bodies, for means over the bodies of several runs.
enum class FromBody {
  kNothing,    // not of bodies
  kField,      // mean of a field of the body's row in the result
  kCoverage,   // visible frames that are estimated
  kSuccess,    // visible frames within a limit
  kSum,        // sum of a field
  kMaxDrift,   // mean of one of MaxDrifts
  kUnmatched,  // number of bodies without a cluster
};

// What its function computes, which its contract says.
struct Relation {
  Alignment alignment;
  Pairing pairing;
  Delta delta;
  Aggregation aggregation;
};

struct MetricEntry {
  MetricId id;
  MetricFamily family;
  const char* name;  // of refined poses, and of bodies that move
  MetricUnit unit;
  Relation relation;
  MetricKind kind;
  FromBody from_body;
  std::optional<double> BodyRow::*body_error;  // of kField
  int BodyRow::*body_count;                    // of kSum
  double limit_m;                              // of kSuccess
  bool of_predictions;                         // also of bodies whose pose is predicted
  const char* label;                           // heads a column
  const char* meaning;                         // for readers who do not know it

  bool higher_is_better() const { return kind == MetricKind::kFraction; }
  // The least step worth telling, of a figure that is `value`: a hundredth of an error, 0.01 of a
  // fraction, one event.
  double Resolution(double value) const;
};

const MetricEntry& EntryOf(MetricId id);

// The metric of value `index` of MaxDrifts::Values, for kCameraMaxDrift or kObjectMaxDrift; and the
// index of one, empty for other metrics.
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

// One form of a metric, and its name: "object_causal_standing_ate".
struct MetricForm {
  MetricId id = MetricId::kCameraAte;
  BodyGroup bodies = BodyGroup::kMovers;
  bool causal = false;  // poses as estimated when their frame came
};
std::string MetricName(const MetricForm& form);
// Empty for a name that is none.
std::optional<MetricForm> FindForm(const std::string& name);

// The part of its contract that is the same for every run.
Contract RelationOf(const MetricForm& form);

// The names of all forms.
std::vector<std::string> AllMetricNames();

// The entry of any form; nullptr for a name that is none.
const MetricEntry* FindEntry(const std::string& name);

// Throws Error naming `where` and the metric for a value that no run can have; that of a name that
// is none need only be of a size that can be.
void CheckPossible(const std::string& name, double value, const std::string& where);

// What heads its column, as "object ATE" or "causal object ATE"; a name that is none as it is.
std::string MetricLabel(const std::string& name);

// The coverage that a metric must be read with, such as "object_coverage" for "object_ate"; empty
// for those of landmarks.
std::string CoverageOf(const std::string& name);

}  // namespace cvo::reports
