// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Metrics, tables and reference figures must use the same names and contracts.
#include <gtest/gtest.h>

#include "experiments/metrics/camera_metrics.h"
#include "reports/tables/columns.h"
#include "reports/tables/reference.h"

namespace cvo::reports {
namespace {

// Metrics of a straight drive of 200 m, as a result file holds them.
std::vector<Metric> RecordedMetrics() {
  OptionalPoses poses;
  for (int i = 0; i <= 200; ++i) {
    poses.emplace_back(
        RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.0, 0.0, i)));
  }
  std::vector<Metric> metrics = EvaluateCamera(poses, poses, TruthSource::kDevkit);
  StatePoses(PoseTime::kRefined, 0.0, metrics);
  return metrics;
}

TEST(ReferenceContract, TablesAskForMetricsThatExist) {
  const std::vector<Metric> metrics = RecordedMetrics();
  for (const std::string& name : CameraMetrics()) {
    EXPECT_NE(cvo::FindMetric(metrics, name), nullptr) << name;
  }
}

TEST(ReferenceContract, EveryMetricOfTheCameraIsComputed) {
  const std::vector<Metric> metrics = RecordedMetrics();
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const MetricEntry& entry = EntryOf(static_cast<MetricId>(i));
    if (entry.family != MetricFamily::kCamera) continue;
    EXPECT_NE(cvo::FindMetric(metrics, entry.name), nullptr) << entry.name;
  }
}

// Reference figures listed under a metric of ours agree with its contract in all fields they state.
TEST(ReferenceContract, FiguresDoNotContradictTheirMetric) {
  const std::vector<Metric> metrics = RecordedMetrics();
  for (const ReferenceFigure& figure : ShippedReference().figures) {
    if (!figure.metric.starts_with("camera_")) continue;
    const Metric* recorded = cvo::FindMetric(metrics, figure.metric);
    ASSERT_NE(recorded, nullptr) << figure.metric;
    EXPECT_EQ(recorded->unit, figure.unit);
    const Contract stated = WithTruthOf(figure.contract, recorded->contract);
    EXPECT_EQ(ContradictingField(recorded->contract, stated), "") << figure.metric;
  }
}

}  // namespace
}  // namespace cvo::reports
