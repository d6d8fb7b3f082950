// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/lists.h"
#include "core/labelling/cluster_labels.h"
#include "core/labelling/frame_points.h"
#include "tests/core/labelling/labelled_frame.h"

namespace cvo::label_scene_test {
namespace {

using test::Moving;
using testing::ElementsAre;

// Tests the input of the CRF for a frame, and the mapping of its labels to clusters.

constexpr ClusterId kNone{};

constexpr NewBodyRule kNearest = &BodiesByDepth::Candidates;

// The node of a static landmark observed in frames 1 to 3; the current frame is 4.
CrfNode NodeOfThreeFrames(int past_frames) {
  Moving m;
  m.options.unary.past_frames = past_frames;
  m.window.landmarks = {Moving::Seen(m.p_in_world, [&](std::int64_t) { return m.p_in_world; })};
  m.window.landmarks[0].p_in_object.z() += 0.5;
  std::erase_if(m.window.landmarks[0].observations,
                [](const Observation& seen) { return seen.frame == FrameId{0}; });
  m.Add(m.p_in_world, kSceneOwner, 0, kStaticScene);
  return m
      .With([&](const FrameView& view) {
        return BuildCrfScene(view, kNearest, m.window, m.map, m.tracks, m.points);
      })
      .nodes.at(0);
}

TEST(BuildCrfScene, PastIsTheExactFrame) {
  EXPECT_TRUE(NodeOfThreeFrames(3).past);
  EXPECT_FALSE(NodeOfThreeFrames(4).past);
}

TEST(BuildCrfScene, LandmarkPositionIsEstimated) {
  const CrfNode node = NodeOfThreeFrames(3);
  ASSERT_TRUE(node.estimate);
  EXPECT_NEAR(node.estimate->p_in_camera.z(), node.p_in_camera.z() + 0.5, 1e-9);
  EXPECT_TRUE(node.estimate->covariance_m2.isZero());
}

TEST(BuildCrfScene, NonPositiveDisparitiesAreFarAway) {
  for (const double disparity_px : {0.0, -0.3}) {
    Moving m;
    m.window.landmarks = {Moving::Seen(m.p_in_world, [&](std::int64_t) { return m.p_in_world; })};
    m.Add(m.p_in_world, kSceneOwner, 0, kStaticScene);
    m.frame.features[0].z_px[2] = m.frame.features[0].z_px[0] - disparity_px;
    const CrfScene scene = m.With([&](const FrameView& view) {
      return BuildCrfScene(view, kNearest, m.window, m.map, m.tracks, m.points);
    });
    const CrfNode& node = scene.nodes.at(0);
    EXPECT_NEAR(node.p_in_camera.z(), 450.0 * 0.3 / 0.1, 1e-6);
    EXPECT_TRUE(node.covariance_m2.allFinite());
  }
}

// A detection beside the cluster of Moving, with as many rows of points as columns, whose depths
// are given from left to right.
struct NewBox {
  Moving m;

  explicit NewBox(const std::vector<double>& columns_m) {
    const ImageBox box{350.0, 200.0, 400.0, 260.0};
    m.frame.detections = {{box, "Car", 1.0}};
    const int k = static_cast<int>(columns_m.size());
    for (int i = 0; i < k * k; ++i) {
      const Eigen::Vector3d ray((box.left_px + 50.0 * (i % k) / k - 320.0) / 450.0,
                                (box.top_px + 60.0 * (i / k) / k - 240.0) / 450.0, 1.0);
      m.Add(columns_m[i % k] * ray, kNoOwner, -1, kNone);
    }
  }
  // Depth of the new body; 0 if there is none.
  double Depth(NewBodyRule candidates_of) {
    const CrfScene scene = m.With([&](const FrameView& view) {
      return BuildCrfScene(view, candidates_of, m.window, m.map, m.tracks, m.points);
    });
    const CrfLabel* label = FindBy(scene.labels, &CrfLabel::kind, LabelKind::kNewBox);
    return label == nullptr ? 0.0 : label->extent->center_in_camera.z();
  }
};

TEST(BuildCrfScene, ANewBodyIsTheNearestDepthThatFillsItsBoxOrAllPoints) {
  constexpr NewBodyRule kAll = &BodiesOfAllPoints::Candidates;
  EXPECT_NEAR(NewBox({7.0, 7.0, 7.0, 12.0, 12.0}).Depth(kNearest), 7.0, 1e-9);
  EXPECT_NEAR(NewBox({4.0, 7.0, 7.0, 7.0, 7.0}).Depth(kNearest), 7.0, 1e-9) << "a strip before it";
  EXPECT_NEAR(NewBox({7.0, 7.0, 7.0, 12.0, 12.0}).Depth(kAll), 9.5, 1e-9);
  EXPECT_EQ(NewBox({7.0, 7.0}).Depth(kAll), 0.0) << "four points";
}

TEST(BuildCrfScene, NoNewBodyInABoxOfAClusterOrOfItsPoints) {
  const std::vector<double> columns_m(5, 7.0);
  NewBox claimed(columns_m);
  claimed.m.tracks[0].detection = 0;
  EXPECT_EQ(claimed.Depth(kNearest), 0.0);
  NewBox owned(columns_m);
  owned.m.map.live[0].landmarks.resize(1);
  for (FramePoint& point : owned.m.points) {
    point.owner = 0;
    point.landmark = 0;
  }
  EXPECT_EQ(owned.Depth(kNearest), 0.0);
}

// Two clusters exchange their labels, and the label of a third starts a new cluster.
TEST(NameLabels, BoxesFollowTheLabels) {
  std::vector<CrfLabel> crf_labels(5);
  ClusterMap map;
  map.live.resize(3);
  for (int q = 0; q < 3; ++q) {
    map.live[q].id = ClusterId{q + 1};
    crf_labels[q + 1] = {.kind = LabelKind::kCluster, .cluster = map.live[q].id, .detection = q};
  }
  crf_labels[4].kind = LabelKind::kOutlier;
  std::vector<ClusterId> cluster_of = {kStaticScene, ClusterId{2}, ClusterId{1}, kNone, kNone};
  FrameLabels labels;
  NameLabels(ClusterId{9}, crf_labels, cluster_of, labels);
  EXPECT_THAT(cluster_of,
              ElementsAre(kStaticScene, ClusterId{2}, ClusterId{1}, ClusterId{9}, kNone));
  std::vector<ClusterTrack> tracks(3);
  for (int q = 0; q < 3; ++q) tracks[q].detection = q;
  AdoptDetections(labels, map, tracks);
  EXPECT_EQ(tracks[0].detection, 1);
  EXPECT_EQ(tracks[1].detection, 0);
  EXPECT_EQ(tracks[2].detection, -1);
}

}  // namespace
}  // namespace cvo::label_scene_test
