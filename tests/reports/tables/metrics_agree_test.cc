// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Metrics, tables and reference figures must use the same names, contracts and, for metrics that
// tables compute from the bodies of a result file, the same values.
#include <gtest/gtest.h>

#include <set>

#include "core/base/rng.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/objects/object_scores.h"
#include "reports/tables/cells.h"
#include "reports/tables/make_table.h"
#include "tests/reports/results/result_files.h"

namespace cvo::reports {
namespace {

BodyScore RandomBody(int id, Rng& rng) {
  BodyScore body;
  body.id = id;
  body.mover = id % 3 != 0;
  body.visible_frames = 40 + id;
  if (id == 5) return body;  // matched to no cluster
  body.cluster = id;
  body.estimated_frames = 30;
  body.id_switches = id;
  body.fragments = 2 * id;
  const auto add = [&rng](FrameErrors& errors, int frame, double scale_m) {
    errors.frames.push_back(frame);
    errors.position_m.push_back(scale_m * rng.Uniform());
  };
  for (int frame = 0; frame < 30; ++frame) add(body.errors, frame, 0.2);
  for (int frame = 30; frame < 34 + id; ++frame) add(body.predicted, frame, 0.3);
  body.ate_m = rng.Uniform();
  body.predicted_ate_m = rng.Uniform();
  body.velocity_m_s = rng.Uniform();
  for (auto member : {&BodyRow::all_pairs_rad, &BodyRow::all_pairs_m, &BodyRow::one_frame_rad,
                      &BodyRow::one_frame_m, &BodyRow::motion_rad, &BodyRow::motion_m,
                      &BodyRow::ate_in_camera_m, &BodyRow::motion_in_camera_m}) {
    const bool known =
        id != 2 || (member != &BodyRow::one_frame_rad && member != &BodyRow::one_frame_m);
    if (known) body.*member = rng.Uniform();
  }
  if (body.mover) {
    body.max_drift.emplace();
    for (MaxDrift* drift : {&body.max_drift->all_poses, &body.max_drift->all_motions,
                            &body.max_drift->first_motions}) {
      *drift = {rng.Uniform(), rng.Uniform(), rng.Uniform(), rng.Uniform()};
    }
  }
  return body;
}

TEST(BodyMetrics, TablesOfOneRunAgreeWithItsMetrics) {
  Rng rng(7, "bodies");
  ObjectTruth truth;
  truth.contract.truth = TruthSource::kScene;
  ObjectScores scores;
  for (int id = 1; id <= 9; ++id) scores.bodies.push_back(RandomBody(id, rng));
  const std::vector<Metric> metrics = ObjectMetrics(truth, scores);
  test::SuiteResults suite;
  suite.table["metrics"] = Json::array();
  test::Json result = test::Result();
  result["metrics"] = ToJson(metrics);
  result["bodies"] = {
      {"refined", ToJson(std::vector<BodyRow>(scores.bodies.begin(), scores.bodies.end()))},
      {"causal", Json::array()}};
  std::set<MetricId> computed;
  for (const Metric& metric : metrics) {
    computed.insert(FindForm(metric.name)->id);
    suite.table["metrics"].push_back(metric.name);
  }
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const MetricEntry& entry = EntryOf(static_cast<MetricId>(i));
    if (entry.family != MetricFamily::kBodies) continue;
    EXPECT_TRUE(computed.contains(entry.id)) << entry.name;
  }
  suite.Add(result);
  const Table table = MakeTable(suite.Written(), {}, "");
  ASSERT_EQ(table.columns.size(), metrics.size());
  ASSERT_GT(metrics.size(), 30U);
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const Cell& cell = table.rows[0].cells[i];
    ASSERT_EQ(table.columns[i].metric, metrics[i].name);
    ASSERT_TRUE(cell.value) << metrics[i].name;
    EXPECT_NEAR(*cell.value, metrics[i].value, 1e-12) << metrics[i].name;
    EXPECT_GT(cell.n.bodies, 0U);
  }
}

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

TEST(ReferenceContract, EveryMetricOfTheCameraIsComputed) {
  const std::vector<Metric> metrics = RecordedMetrics();
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const MetricEntry& entry = EntryOf(static_cast<MetricId>(i));
    const bool of_velocities =
        entry.id == MetricId::kCameraAteVelocity || entry.id == MetricId::kCameraTruthGap;
    if (entry.family != MetricFamily::kCamera || of_velocities) continue;
    EXPECT_NE(cvo::FindMetric(metrics, entry.name), nullptr) << entry.name;
  }
}

// Reference figures listed under a metric of ours agree with its contract in all fields they state.
TEST(ReferenceContract, FiguresDoNotContradictTheirMetric) {
  const std::vector<Metric> metrics = RecordedMetrics();
  for (const ReferenceFigure& figure : ShippedReference()) {
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
