// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/camera_metrics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/median.h"
#include "experiments/metrics/kitti_drift.h"

namespace cvo {
namespace {

using reports::MetricId;
using enum reports::MetricId;

// How many frames enter, and the contract fields that all camera metrics share.
struct Frames {
  std::int64_t all = 0;
  std::int64_t with_truth = 0;
  std::int64_t common = 0;
  std::string truth_name;

  MetricContract Contract() const {
    MetricContract contract;
    contract.frame = "left camera";
    contract.truth = truth_name;
    contract.alignment = "none";
    contract.delta = "none";
    contract.left_out = StrCat(all - with_truth, " of ", all, " frames without truth, ",
                               with_truth - common, " with truth but without an estimate");
    return contract;
  }
};

Metric Coverage(const Frames& frames) {
  MetricContract contract = frames.Contract();
  contract.pairing = "all frames with truth";
  contract.aggregation = "fraction with an estimate";
  contract.left_out =
      StrCat(frames.all - frames.with_truth, " of ", frames.all, " frames without truth");
  return MakeMetric({kCameraCoverage},
                    static_cast<double>(frames.common) / static_cast<double>(frames.with_truth),
                    frames.with_truth, contract);
}

void AddAte(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  const std::vector<double> errors = AlignedPositionErrors(poses);
  const auto n = static_cast<double>(errors.size());
  const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
  const double squares = std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0);
  MetricContract contract = frames.Contract();
  contract.alignment = "SE(3) over positions, Umeyama without scale";
  contract.pairing = "all frames with truth and estimate";
  const auto add = [&](MetricId id, double value, const char* aggregation) {
    contract.aggregation = aggregation;
    metrics.push_back(MakeMetric({id}, value, frames.common, contract));
  };
  add(kCameraAte, std::sqrt(squares / n), "root mean square of position errors");
  add(kCameraAteMean, sum / n, "mean of position errors");
  add(kCameraAteMedian, Median(errors), "median of position errors");
  add(kCameraAteMax, *std::max_element(errors.begin(), errors.end()), "maximum of position errors");
}

void AddRelative(const RelativeErrors& errors, MetricId rotation, MetricId translation,
                 const MetricContract& base, std::vector<Metric>& metrics) {
  MetricContract contract = base;
  contract.aggregation = "root mean square of rotation angles";
  metrics.push_back(MakeMetric({rotation}, errors.rotation_rad, errors.pairs, contract));
  contract.aggregation = "root mean square of translation norms";
  metrics.push_back(MakeMetric({translation}, errors.translation_m, errors.pairs, contract));
}

void AddRpe(const CommonPoses& poses, const Frames& frames, std::vector<Metric>& metrics) {
  MetricContract contract = frames.Contract();
  if (const auto errors = AllPairsErrors(poses)) {
    contract.pairing = "all ordered pairs i != j of frames with truth and estimate";
    contract.delta = "all";
    AddRelative(*errors, kCameraRrpeAllPairs, kCameraTrpeAllPairs, contract, metrics);
  }
  if (const auto errors = OneFrameErrors(poses)) {
    contract.pairing = "consecutive frames with truth and estimate";
    contract.delta = "1 frame";
    AddRelative(*errors, kCameraRrpe1Frame, kCameraTrpe1Frame, contract, metrics);
  }
}

void AddDrift(const KittiDrift& drift, const Frames& frames, std::vector<Metric>& metrics) {
  MetricContract contract = frames.Contract();
  contract.pairing = "KITTI devkit sub-sequences that start at every 10th frame";
  contract.delta = "100, 200, ..., 800 m of the true path";
  contract.left_out +=
      StrCat("; ", drift.segments_without_estimate, " sub-sequences without an estimate at an end");
  contract.aggregation = "mean of translation errors over length";
  metrics.push_back(
      MakeMetric({kCameraTDrift}, drift.translation_percent, drift.segments, contract));
  contract.aggregation = "mean of rotation errors over length";
  metrics.push_back(
      MakeMetric({kCameraRDrift}, drift.rotation_deg_per_100m, drift.segments, contract));
}

}  // namespace

std::vector<Metric> EvaluateCamera(const OptionalPoses& truth, const OptionalPoses& estimate,
                                   const std::string& truth_name) {
  const CommonPoses poses = FindCommonPoses(truth, estimate);
  Frames frames;
  frames.all = static_cast<std::int64_t>(truth.size());
  frames.with_truth =
      std::count_if(truth.begin(), truth.end(), [](const auto& pose) { return pose.has_value(); });
  frames.common = static_cast<std::int64_t>(poses.size());
  frames.truth_name = truth_name;

  std::vector<Metric> metrics;
  if (frames.with_truth > 0) metrics.push_back(Coverage(frames));
  if (frames.common < 2) return metrics;
  AddAte(poses, frames, metrics);
  AddRpe(poses, frames, metrics);
  if (const auto drift = ComputeKittiDrift(truth, estimate)) AddDrift(*drift, frames, metrics);
  for (const Metric& metric : metrics) {
    if (!std::isfinite(metric.value)) ThrowError(metric.name, "an overflow", "a finite number");
  }
  return metrics;
}

const Metric* FindMetric(const std::vector<Metric>& metrics, const std::string& name) {
  const auto metric =
      std::find_if(metrics.begin(), metrics.end(), [&](const Metric& m) { return m.name == name; });
  return metric == metrics.end() ? nullptr : &*metric;
}

}  // namespace cvo
