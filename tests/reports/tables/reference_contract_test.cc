// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tables and metrics meet in files only: that they use the same names and words is checked here.
#include <gtest/gtest.h>

#include "experiments/metrics/camera_metrics.h"
#include "experiments/record/metrics_json.h"
#include "reports/tables/columns.h"
#include "reports/tables/reference.h"

namespace cvo::reports {
namespace {

// Metrics of a straight drive of 200 m, as a result file holds them.
Json RecordedMetrics() {
  OptionalPoses poses;
  for (int i = 0; i <= 200; ++i) {
    poses.emplace_back(
        RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.0, 0.0, i)));
  }
  return MetricsToJson(EvaluateCamera(poses, poses, "devkit"), "refined");
}

const Json* FindRecorded(const Json& metrics, const std::string& name) {
  for (const Json& metric : metrics) {
    if (metric["name"] == name) return &metric;
  }
  return nullptr;
}

TEST(ReferenceContract, TablesAskForMetricsThatExist) {
  const Json metrics = RecordedMetrics();
  for (const std::string& name : CameraMetrics()) {
    EXPECT_NE(FindRecorded(metrics, name), nullptr) << name;
  }
}

TEST(ReferenceContract, EveryMetricOfTheCameraIsComputed) {
  const Json metrics = RecordedMetrics();
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const MetricEntry& entry = EntryOf(static_cast<MetricId>(i));
    if (entry.family != MetricFamily::kCamera) continue;
    const Json* recorded = FindRecorded(metrics, entry.name);
    ASSERT_NE(recorded, nullptr) << entry.name;
    EXPECT_EQ((*recorded)["unit"], entry.unit);
  }
}

TEST(ReferenceContract, FieldsThatASourceStatesAreWordedAsInResults) {
  const Json metrics = RecordedMetrics();
  for (const ReferenceFigure& figure : ShippedReference().figures) {
    if (!figure.metric.starts_with("camera_")) continue;
    const Json* recorded = FindRecorded(metrics, figure.metric);
    ASSERT_NE(recorded, nullptr) << figure.metric;
    EXPECT_EQ((*recorded)["unit"], figure.unit);
    for (const auto& [field, words] : figure.contract) {
      if (words.empty() || field == "truth") continue;
      EXPECT_EQ((*recorded)["contract"].value(field, ""), words) << figure.metric << ", " << field;
    }
  }
}

}  // namespace
}  // namespace cvo::reports
