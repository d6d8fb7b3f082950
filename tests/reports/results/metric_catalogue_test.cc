// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/record/metric_catalogue.h"

#include <gtest/gtest.h>

#include <set>

namespace cvo::reports {
namespace {

TEST(MetricCatalogue, EveryFormHasAUniqueName) {
  std::set<std::string> names;
  for (const std::string& name : AllMetricNames()) {
    EXPECT_TRUE(names.insert(name).second) << name;
    ASSERT_TRUE(FindForm(name)) << name;
    EXPECT_EQ(MetricName(*FindForm(name)), name);
  }
  EXPECT_EQ(names.size(), 159U);
  EXPECT_TRUE(names.contains("object_causal_standing_ate"));
  EXPECT_TRUE(names.contains("object_predicted_success_5cm"));
  EXPECT_FALSE(names.contains("object_predicted_coverage"));
  EXPECT_FALSE(names.contains("moving_causal_recall"));
  EXPECT_FALSE(names.contains("object_causal_max_drift"));
  EXPECT_FALSE(FindForm("ate"));
}

TEST(MetricCatalogue, ColumnsOfOneTableHaveUniqueHeadings) {
  std::set<std::string> headings;
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const MetricEntry& entry = EntryOf(static_cast<MetricId>(i));
    EXPECT_TRUE(headings.insert(std::string(entry.label) + " " + NameOf(entry.unit)).second)
        << entry.name;
    EXPECT_EQ(MetricLabel(entry.name), entry.label);
  }
  EXPECT_EQ(MetricLabel("camera_causal_ate"), "causal camera ATE");
  EXPECT_EQ(MetricLabel("object_causal_standing_ate"), "causal standing object ATE");
  EXPECT_EQ(MetricLabel("other"), "other");
}

TEST(MetricCatalogue, RotationsHaveOneUnit) {
  for (const char* name : {"camera_rrpe_all_pairs", "camera_rrpe_1_frame", "object_rrpe_all_pairs",
                           "object_rrpe_1_frame", "object_motion_r"}) {
    EXPECT_EQ(FindEntry(name)->unit, MetricUnit::kRadians) << name;
  }
}

TEST(MetricCatalogue, NamesTheCoverageOfAMetric) {
  EXPECT_EQ(CoverageOf("camera_ate"), "camera_coverage");
  EXPECT_EQ(CoverageOf("camera_causal_t_drift"), "camera_causal_coverage");
  EXPECT_EQ(CoverageOf("object_standing_ate"), "object_standing_coverage");
  EXPECT_EQ(CoverageOf("object_causal_predicted_ate"), "object_causal_coverage");
  EXPECT_EQ(CoverageOf("object_unmatched_clusters"), "object_coverage");
  EXPECT_EQ(CoverageOf("moving_recall"), "");
  EXPECT_EQ(CoverageOf("box_ap_3d_moderate"), "");
  EXPECT_EQ(CoverageOf("wall_s"), "");
}

}  // namespace
}  // namespace cvo::reports
