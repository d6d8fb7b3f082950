// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/camera_metrics.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/base/mean.h"
#include "core/base/median.h"
#include "experiments/metrics/kitti_drift.h"
#include "experiments/metrics/max_drift.h"

namespace cvo {
namespace {

using reports::MetricId;
using enum reports::MetricId;

// Numbers of frames, and what the contracts of all camera metrics share.
struct Frames {
  std::int64_t all = 0;
  std::int64_t with_truth = 0;
  std::int64_t common = 0;
  std::optional<reports::TruthSource> truth;

  Metric Make(MetricId id, double value, std::int64_t n) const {
    Metric metric = MakeMetric({id}, value, n);
    metric.contract.subject = reports::Subject::kCamera;
    metric.contract.truth = truth;
    metric.left_out = StrCat(all - with_truth, " of ", all, " frames without truth, ",
                             with_truth - common, " with truth but without an estimate");
    return metric;
  }
};

Metric Coverage(const Frames& frames) {
  Metric metric = frames.Make(
      kCameraCoverage, static_cast<double>(frames.common) / static_cast<double>(frames.with_truth),
      frames.with_truth);
  metric.left_out =
      StrCat(frames.all - frames.with_truth, " of ", frames.all, " frames without truth");
  return metric;
}

void AddAte(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const std::vector<double> errors = AlignedPositionErrors(poses);
  const auto add = [&](MetricId id, double value) {
    metrics.push_back(frames.Make(id, value, frames.common));
  };
  add(kCameraAte, RootMeanSquare(errors).value());
  add(kCameraAteMean, MeanOf(errors));
  add(kCameraAteMedian, Median(errors));
  add(kCameraAteMax, *std::max_element(errors.begin(), errors.end()));
}

void AddRpe(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const auto add = [&](const RelativeErrors& errors, MetricId rotation, MetricId translation) {
    if (errors.rotation_rad) {
      metrics.push_back(frames.Make(rotation, *errors.rotation_rad, errors.pairs));
    }
    metrics.push_back(frames.Make(translation, errors.translation_m, errors.pairs));
    if (!errors.rotation_rad) {
      metrics.back().left_out +=
          StrCat("; rotations of all pairs: more than ", kMaxPairedRotations, " poses");
    }
  };
  if (const auto errors = AllPairsErrors(poses)) {
    add(*errors, kCameraRrpeAllPairs, kCameraTrpeAllPairs);
  }
  if (const auto errors = OneFrameErrors(poses)) {
    add(*errors, kCameraRrpe1Frame, kCameraTrpe1Frame);
  }
}

void AddPathError(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const auto lengths = ConsecutiveLengths(poses);
  if (!lengths || !(lengths->truth_m > 0.0)) return;
  metrics.push_back(frames.Make(kCameraPathError,
                                100.0 * std::abs(lengths->estimate_m / lengths->truth_m - 1.0),
                                lengths->pairs));
}

void AddDrift(const KittiDrift& drift, const Frames& frames, std::vector<Metric>& metrics) {
  const auto add = [&](MetricId id, double value) {
    metrics.push_back(frames.Make(id, value, drift.segments));
    metrics.back().left_out += StrCat("; ", drift.segments_without_estimate,
                                      " sub-sequences without an estimate at an end");
  };
  add(kCameraTDrift, drift.translation_percent);
  add(kCameraRDrift, drift.rotation_deg_per_100m);
}

void AddMaxDrift(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const auto drifts = MeasureMaxDrift(poses, AlignAtFirst(poses));
  if (!drifts) return;
  const std::array values = drifts->Values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    metrics.push_back(
        frames.Make(reports::MaxDriftMetric(kCameraMaxDrift, i), values[i], frames.common));
  }
}

}  // namespace

std::vector<Metric> EvaluateCamera(const OptionalPoses& truth, const OptionalPoses& estimate,
                                   std::optional<reports::TruthSource> source) {
  const CommonPoses poses = FindCommonPoses(truth, estimate);
  Frames frames;
  frames.all = static_cast<std::int64_t>(truth.size());
  frames.with_truth =
      std::count_if(truth.begin(), truth.end(), [](const auto& pose) { return pose.has_value(); });
  frames.common = static_cast<std::int64_t>(poses.size());
  frames.truth = source;

  std::vector<Metric> metrics;
  if (frames.with_truth > 0) metrics.push_back(Coverage(frames));
  if (frames.common < 2) return metrics;
  AddAte(poses, frames, metrics);
  AddRpe(poses, frames, metrics);
  if (const auto drift = ComputeKittiDrift(truth, estimate)) AddDrift(*drift, frames, metrics);
  AddPathError(poses, frames, metrics);
  AddMaxDrift(poses, frames, metrics);
  for (const Metric& metric : metrics) {
    if (!std::isfinite(metric.value)) ThrowError(metric.name, "an overflow", "a finite number");
  }
  return metrics;
}

const Metric* FindMetric(const std::vector<Metric>& metrics, const std::string& name) {
  return FindBy(metrics, &Metric::name, name);
}

}  // namespace cvo
