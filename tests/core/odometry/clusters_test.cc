// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests every variant on a world with moving bodies: invariants, and degenerate input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/cluster_run.h"

namespace cvo {
namespace {

using test::ClusterRun;
using test::MovingWorld;
using test::RunClusters;
using test::RunSettings;
using test::WorldView;
using testing::IsEmpty;

class EveryVariantWithBodies : public testing::TestWithParam<std::string_view> {
 protected:
  template <typename Change>
  ClusterRun Watch(int frames, Change change) const {
    RunSettings settings;
    settings.frames = frames;
    return RunClusters(GetParam(), world_, settings, change);
  }

  // Variants of static have no bodies. Variants with printed equations are not checked, because
  // the printed affinity term leaves almost no landmarks to the bodies (METHOD.md 5.4).
  static bool IsPrinted() { return GetParam().starts_with("printed_"); }
  static void ExpectClusters(bool are_there) {
    if (IsPrinted()) return;
    EXPECT_NE(are_there, IsStatic());
  }
  static bool IsStatic() {
    const std::string name(GetParam());
    return name.starts_with("static") || name == "frame_to_frame" || name == "mask_static";
  }

  MovingWorld world_{5, test::TwoBodies()};
};

std::vector<std::string_view> VariantNames() {
  std::vector<std::string_view> names;
  for (const VariantInfo& variant : NamedVariantInfos()) names.push_back(variant.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Clusters, EveryVariantWithBodies, testing::ValuesIn(VariantNames()),
                         [](const auto& variant) { return std::string(variant.param); });

// Returns the position error of the camera in a report, m.
double CameraError(const FrameReport& report, int frame) {
  return (report.world_from_camera.translation() - MovingWorld::CameraAt(frame).translation())
      .norm();
}

void ExpectSameBytes(const RigidTransform& a, const RigidTransform& b) {
  for (int k = 0; k < 7; ++k) EXPECT_EQ(a.data()[k], b.data()[k]);
}

void ExpectSameBytes(const ClusterTrajectory& a, const ClusterTrajectory& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.category, b.category);
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    EXPECT_EQ(a.poses[i].frame, b.poses[i].frame);
    EXPECT_EQ(a.poses[i].status, b.poses[i].status);
    ExpectSameBytes(a.poses[i].world_from_object, b.poses[i].world_from_object);
    EXPECT_TRUE(a.poses[i].velocity_m_s.cwiseEqual(b.poses[i].velocity_m_s).all());
  }
}

void ExpectSameBytes(const ClusterReport& a, const ClusterReport& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.detection, b.detection);
  EXPECT_EQ(a.observed_landmarks, b.observed_landmarks);
  EXPECT_EQ(a.score, b.score);
  ExpectSameBytes(a.world_from_object, b.world_from_object);
  EXPECT_TRUE(a.center_in_object.cwiseEqual(b.center_in_object).all());
  EXPECT_TRUE(a.half_size_m.cwiseEqual(b.half_size_m).all());
}

void ExpectSameBytes(const FrameReport& a, const FrameReport& b) {
  EXPECT_EQ(a.status, b.status);
  ExpectSameBytes(a.world_from_camera, b.world_from_camera);
  ASSERT_EQ(a.clusters.size(), b.clusters.size());
  for (std::size_t q = 0; q < a.clusters.size(); ++q) ExpectSameBytes(a.clusters[q], b.clusters[q]);
  ASSERT_EQ(a.landmarks.size(), b.landmarks.size());
  for (std::size_t i = 0; i < a.landmarks.size(); ++i) {
    EXPECT_EQ(a.landmarks[i].id, b.landmarks[i].id);
    EXPECT_EQ(a.landmarks[i].cluster, b.landmarks[i].cluster);
    EXPECT_EQ(a.landmarks[i].inferred, b.landmarks[i].inferred);
    EXPECT_EQ(a.landmarks[i].confidence, b.landmarks[i].confidence);
  }
}

// Checks that the poses of every report are finite, and clusters and landmarks sorted.
void ExpectSound(const ClusterRun& run) {
  ASSERT_EQ(run.trajectory.size(), run.reports.size());
  for (const FrameReport& report : run.reports) {
    EXPECT_TRUE(report.world_from_camera.Matrix().allFinite());
    for (std::size_t q = 0; q < report.clusters.size(); ++q) {
      const ClusterReport& cluster = report.clusters[q];
      EXPECT_TRUE(cluster.world_from_object.Matrix().allFinite());
      EXPECT_TRUE(cluster.velocity_m_s.allFinite());
      EXPECT_TRUE(cluster.half_size_m.allFinite());
      EXPECT_TRUE(q == 0 || report.clusters[q - 1].id < cluster.id);
    }
    for (std::size_t i = 1; i < report.landmarks.size(); ++i) {
      EXPECT_LT(report.landmarks[i - 1].feature, report.landmarks[i].feature);
    }
  }
  for (const ClusterTrajectory& cluster : run.clusters) {
    EXPECT_TRUE(cluster.id > kStaticScene);
    for (std::size_t i = 1; i < cluster.poses.size(); ++i) {
      EXPECT_LT(cluster.poses[i - 1].frame, cluster.poses[i].frame);
    }
  }
}

TEST_P(EveryVariantWithBodies, IsIdenticalForAnyThreadCount) {
  RunSettings settings;
  settings.frames = 22;
  const ClusterRun one = RunClusters(GetParam(), world_, settings, test::kNoChange);
  settings.threads = 3;
  const ClusterRun three = RunClusters(GetParam(), world_, settings, test::kNoChange);
  ExpectSound(one);
  for (int i = 0; i < settings.frames; ++i) {
    ExpectSameBytes(one.trajectory[i], three.trajectory[i]);
    ExpectSameBytes(one.reports[i], three.reports[i]);
  }
  ASSERT_EQ(one.clusters.size(), three.clusters.size());
  for (std::size_t q = 0; q < one.clusters.size(); ++q) {
    ExpectSameBytes(one.clusters[q], three.clusters[q]);
  }
  ExpectClusters(!one.clusters.empty());
}

TEST_P(EveryVariantWithBodies, FindsNothingWithoutDetections) {
  const ClusterRun run = Watch(20, [](int, WorldView& view) { view.frame.detections.clear(); });
  ExpectSound(run);
  EXPECT_THAT(test::ReportedIds(run), IsEmpty());
  EXPECT_THAT(run.clusters, IsEmpty());
  // Bodies that are not known to move bias the camera pose.
  EXPECT_LT(CameraError(run.reports.back(), 19), 0.1);
}

TEST_P(EveryVariantWithBodies, IgnoresBoxesWithoutAreaOrFeatures) {
  const ClusterRun run = Watch(15, [](int i, WorldView& view) {
    view.frame.detections = {{{100, 100, 100, 100}, "cart", 1.0},
                             {{5000, 10, 5400, 400}, "cart", 1.0},
                             {{-900, -900, -800, -800}, "chair", 0.0}};
    if (i % 3 == 0) view.frame.features.clear();
  });
  ExpectSound(run);
  EXPECT_THAT(test::ReportedIds(run), IsEmpty());
}

TEST_P(EveryVariantWithBodies, SurvivesFiveHundredBoxes) {
  const ClusterRun run = Watch(8, [](int i, WorldView& view) {
    if (i != 4) return;
    Rng rng(3, "boxes");
    while (view.frame.detections.size() < 500) {
      const double left = rng.Uniform(-50.0, 600.0);
      const double top = rng.Uniform(-50.0, 440.0);
      view.frame.detections.push_back(
          {{left, top, left + rng.Uniform(2.0, 120.0), top + rng.Uniform(2.0, 120.0)},
           "cart",
           rng.Uniform()});
    }
  });
  ExpectSound(run);
  EXPECT_LT(CameraError(run.reports.back(), 7), 0.3);
}

TEST_P(EveryVariantWithBodies, RecoversAfterTwentyFramesWithoutFeatures) {
  RunSettings settings;
  settings.frames = 42;
  settings.options.clusters.live_frames = 15;
  const ClusterRun run = RunClusters(GetParam(), world_, settings, [](int i, WorldView& view) {
    if (i < 16 || i >= 36) return;
    view.frame.features.clear();
    view.of_body.clear();
  });
  ExpectSound(run);
  for (int i = 16; i < 36; ++i) EXPECT_EQ(run.reports[i].status, FrameStatus::kLost);
  EXPECT_EQ(run.reports[36].status, FrameStatus::kRecovered);
  EXPECT_LT(CameraError(run.reports[36], 36), 0.1);
  // Clusters are predicted first, then removed, and created anew.
  for (const ClusterReport& cluster : run.reports[29].clusters) {
    EXPECT_EQ(cluster.status, ClusterStatus::kPredicted);
  }
  ExpectClusters(!run.reports[29].clusters.empty());
  EXPECT_THAT(run.reports[30].clusters, IsEmpty());
  ExpectClusters(!run.reports[41].clusters.empty());
}

TEST_P(EveryVariantWithBodies, StartsWithTheFirstFrameWithFeatures) {
  const ClusterRun run = Watch(12, [](int i, WorldView& view) {
    if (i > 1) return;
    view.frame.features.clear();
    if (i == 0) view.frame.detections.clear();
  });
  ExpectSound(run);
  EXPECT_EQ(run.reports[0].status, FrameStatus::kLost);
  EXPECT_EQ(run.reports[1].status, FrameStatus::kLost);
  EXPECT_EQ(run.reports[2].status, FrameStatus::kFirst);
  EXPECT_EQ(run.reports[3].status, FrameStatus::kTracked);
  ExpectClusters(!run.reports[11].clusters.empty());
}

TEST_P(EveryVariantWithBodies, ReportsNoClusterFromASingleDetection) {
  const ClusterRun run = Watch(16, [](int i, WorldView& view) {
    if (i != 5) view.frame.detections.clear();
  });
  ExpectSound(run);
  EXPECT_THAT(test::ReportedIds(run), IsEmpty());
  EXPECT_THAT(run.clusters, IsEmpty());
}

TEST_P(EveryVariantWithBodies, AcceptsGivenLabelsAndBoxesTogether) {
  const ClusterRun run = Watch(12, [](int, WorldView& view) {
    view.frame.given.feature_body = test::BodyIds(view.of_body);
    view.frame.given.detection_body = test::BodyIds(view.box_body);
  });
  ExpectSound(run);
  EXPECT_EQ(test::ReportedIds(run).size(), IsStatic() ? 0u : 2u);
}

TEST_P(EveryVariantWithBodies, RefusesGivenListsOfTheWrongLength) {
  const auto give_too_few_labels = [](int, WorldView& view) {
    view.frame.given.feature_body = {BodyId{0}, BodyId{1}};
  };
  EXPECT_THROW(Watch(1, give_too_few_labels), Error);
  const auto give_too_many_boxes = [](int, WorldView& view) {
    view.frame.given.detection_body.resize(view.frame.detections.size() + 1);
  };
  EXPECT_THROW(Watch(1, give_too_many_boxes), Error);
}

TEST_P(EveryVariantWithBodies, PredictsClustersInSkippedFrames) {
  const ClusterRun run = Watch(24, [](int i, WorldView& view) {
    if (i == 12 || i == 16 || i == 17) view.frame.timestamp_ns = -1;
  });
  ExpectSound(run);
  for (const int i : {12, 16, 17}) {
    EXPECT_EQ(run.reports[i].status, FrameStatus::kSkipped);
    ExpectClusters(!run.reports[i].clusters.empty());
    for (const ClusterReport& cluster : run.reports[i].clusters) {
      EXPECT_EQ(cluster.status, ClusterStatus::kPredicted);
    }
  }
  EXPECT_EQ(run.reports[18].status, FrameStatus::kTracked);
  // The clusters are the same before and after.
  for (const ClusterReport& cluster : run.reports[11].clusters) {
    EXPECT_NE(test::FindReport(run.reports[20], cluster.id), nullptr) << cluster.id.value;
  }
}

}  // namespace
}  // namespace cvo
