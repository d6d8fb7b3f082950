// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/labelling/cluster_labels.h"
#include "core/labelling/new_bodies.h"
#include "tests/core/labelling/labelled_frame.h"

namespace cvo::label_scene_test {
namespace {

using test::Moving;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// Tests the input of the CRF for a frame, and the mapping of its labels to clusters.

constexpr ClusterId kNone{};

constexpr NewBodyRule kNearest = RuleOf<BodiesByDepth>();

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

// A body 6 m away fills its box, 1.6 m wide. A second box of the given class lies inside that box
// and shows points at the given depth.
int NewBodiesInside(const std::string& category, double depth_m, double part_share) {
  Moving m;
  const ImageBox part{350.0, 200.0, 400.0, 260.0};
  m.frame.detections = {{{290.0, 180.0, 410.0, 300.0}, "Car", 1.0}, {part, category, 1.0}};
  m.tracks[0].detection = 0;
  for (int i = 0; i < 36; ++i) {
    const Eigen::Vector3d ray((part.left_px + 10.0 * (i % 6) - 320.0) / 450.0,
                              (part.top_px + 12.0 * (i / 6) - 240.0) / 450.0, 1.0);
    m.Add(depth_m * ray, kNoOwner, -1, kNone);
  }
  m.options.clusters.part_share = part_share;
  const CrfScene scene = m.With([&](const FrameView& view) {
    return BuildCrfScene(view, kNearest, m.window, m.map, m.tracks, m.points);
  });
  return static_cast<int>(std::ranges::count(scene.labels, LabelKind::kNewBox, &CrfLabel::kind));
}

TEST(BuildCrfScene, ABoxInsideThatOfAClusterIsAPartOfIt) {
  EXPECT_EQ(NewBodiesInside("Car", 7.0, 0.8), 0);
  EXPECT_EQ(NewBodiesInside("Car", 20.0, 0.8), 1) << "far behind the body";
  EXPECT_EQ(NewBodiesInside("Pedestrian", 7.0, 0.8), 1) << "of another class";
  EXPECT_EQ(NewBodiesInside("Car", 7.0, 2.0), 1) << "the rule is off";
}

TEST(NewBodyPolicies, TakeTheNearestDepthsOrAllOfThem) {
  const std::vector<double> depths_m = {2.0, 2.01, 2.02, 2.0, 2.01, 9.0, 9.1};
  EXPECT_THAT(BodiesByDepth::Candidates(depths_m, 0.2), ElementsAre(ElementsAre(0, 1, 2, 3, 4)));
  EXPECT_THAT(BodiesOfAllPoints::Candidates(depths_m, 0.2), ElementsAre(SizeIs(7)));
  EXPECT_THAT(BodiesOfAllPoints::Candidates({2.0, 2.0, 2.0, 2.0}, 0.2), IsEmpty());
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

// Tests new bodies in boxes without a cluster, where one body partly occludes another.

// A near body occludes the right half of a far one, of which only the left part is visible.
struct TwoBoxes {
  ImageBox near_box{300.0, 100.0, 400.0, 300.0};
  ImageBox far_box{200.0, 120.0, 360.0, 260.0};
  Options options;
  StereoFrame frame;
  std::vector<FramePoint> points;
  std::vector<CrfNode> nodes;

  TwoBoxes() {
    frame.detections = {{far_box, "Chair", 1.0}, {near_box, "Chair", 1.0}};
    AddGrid({205.0, 125.0, 290.0, 255.0}, 4, 4.0);
    AddGrid({305.0, 105.0, 395.0, 295.0}, 8, 2.0);
  }

  // Adds k x k points at the given depth.
  void AddGrid(const ImageBox& box, int k, double depth_m) {
    for (int i = 0; i < k * k; ++i) {
      CrfNode node;
      node.z_px = {box.left_px + box.Width() * (i % k) / (k - 1.0),
                   box.top_px + box.Height() * (i / k) / (k - 1.0), 0.0};
      node.p_in_camera = {0.0, 0.0, depth_m};
      nodes.push_back(node);
      points.push_back({});
    }
  }

  // Returns the depth of the new body of each detection; 0 if it has none.
  std::vector<double> Depths(const NewBodyRule& rule, const std::vector<char>& is_claimed) {
    const FeatureGrid grid(frame.features, test::kCamera);
    const FrameView view{frame, UseDetections::Show(frame), grid, test::kCamera, {}, options};
    std::vector<double> depths_m;
    for (const auto& body : FindNewBodies(view, rule, is_claimed, points, nodes)) {
      depths_m.push_back(body ? body->center_in_camera.z() : 0.0);
    }
    return depths_m;
  }
};

TEST(FindNewBodies, OccludingBodyOwnsItsPointsExclusively) {
  EXPECT_THAT(TwoBoxes().Depths(kNearest, {0, 0}), ElementsAre(4.0, 2.0));
}

TEST(FindNewBodies, DepthRangeMustFillTheBox) {
  TwoBoxes boxes;
  boxes.frame.detections.resize(1);
  EXPECT_THAT(boxes.Depths(kNearest, {0}), ElementsAre(2.0));
  boxes.frame.detections[0].box.right_px = 330.0;  // only a strip of the near body is inside
  EXPECT_THAT(boxes.Depths(kNearest, {0}), ElementsAre(4.0));
}

TEST(FindNewBodies, NoneIfAClusterClaimsTheBoxOrOwnsThePoints) {
  TwoBoxes boxes;
  EXPECT_THAT(boxes.Depths(kNearest, {1, 0}), ElementsAre(0.0, 2.0));
  for (FramePoint& point : boxes.points) point.owner = 0;
  EXPECT_THAT(boxes.Depths(kNearest, {0, 0}), ElementsAre(0.0, 0.0));
}

}  // namespace
}  // namespace cvo::label_scene_test
