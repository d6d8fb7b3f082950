// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "experiments/metrics/boxes/average_precision.h"

namespace cvo::box_metrics_test {
namespace {

// A car of 4 x 2 x 1.5 m at x, in frame 7, the first of two frames.
ObjectBox CarAt(double x, double height_px) {
  ObjectBox box;
  box.frame = 7;
  box.type = "Car";
  box.truncation = 0.0;
  box.occlusion = 0;
  box.right_px = 80.0;
  box.bottom_px = height_px;
  box.box3d = ObjectBox::Box3d{1.5, 2.0, 4.0, {x, 1.6, 20.0}, 0.0};
  return box;
}

Sequence Labelled(const std::vector<ObjectBox>& labels) {
  Sequence sequence;
  sequence.first_frame = 7;
  sequence.images.resize(2);
  sequence.labels = labels;
  return sequence;
}

ObjectBox Scored(ObjectBox box, double score) {
  box.score = score;
  return box;
}

// An IoU of exactly 1/4 is not enough: at an offset of 2.4 m, boxes of 4 m share 1.6 of 6.4 m.
TEST(BoxMetrics, CountBoxesThatOverlapByMoreThanAQuarter) {
  const Sequence sequence = Labelled({CarAt(0.0, 50.0)});
  const auto metrics = BoxMetrics(sequence, {Scored(CarAt(2.3, 50.0), 0.4)});
  ASSERT_EQ(metrics.size(), 6U);
  EXPECT_EQ(metrics[0].name, "box_ap_bv_easy");
  EXPECT_EQ(metrics[4].name, "box_ap_3d_moderate");
  for (const Metric& metric : metrics) {
    EXPECT_DOUBLE_EQ(metric.value, 1.0 / 11.0) << metric.name;  // the artefact of 11-point AP
    EXPECT_EQ(metric.n, 1);
    EXPECT_EQ(metric.contract.subject, reports::Subject::kCars);
  }
  for (const Metric& metric : BoxMetrics(sequence, {Scored(CarAt(2.5, 50.0), 0.4)})) {
    EXPECT_EQ(metric.value, 0.0) << metric.name;
  }
}

TEST(BoxMetrics, AreAbsentWithoutLabelsOfTheirLevel) {
  const auto metrics = BoxMetrics(Labelled({CarAt(0.0, 30.0)}), {});  // too small to be easy
  ASSERT_EQ(metrics.size(), 4U);
  EXPECT_EQ(metrics[0].name, "box_ap_bv_moderate");
  EXPECT_EQ(metrics[0].value, 0.0);
  ObjectBox van = CarAt(0.0, 50.0);
  van.type = "Van";
  EXPECT_TRUE(BoxMetrics(Labelled({van}), {Scored(CarAt(0.0, 50.0), 1.0)}).empty());
}

TEST(BoxMetrics, CountTheCarLabelsOfAllFrames) {
  ObjectBox last = CarAt(0.0, 50.0);
  last.frame = 8;
  const auto metrics =
      BoxMetrics(Labelled({CarAt(0.0, 50.0), last}), {Scored(last, 0.5), Scored(last, 0.4)});
  ASSERT_EQ(metrics.size(), 6U);
  EXPECT_EQ(metrics[2].n, 2);
  EXPECT_EQ(metrics[2].contract.truth, reports::TruthSource::kLabels);
  EXPECT_EQ(metrics[2].left_out, "nothing");
  EXPECT_DOUBLE_EQ(metrics[2].value, 1.0 / 11.0);
}

}  // namespace
}  // namespace cvo::box_metrics_test
