// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the input of the CRF for a frame, and the mapping of its labels to clusters.
#include "core/labelling/label_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/core/labelling/labelled_frame.h"

namespace cvo::label_scene_test {
namespace {

using test::Moving;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr ClusterId kNone{};

constexpr LabelSceneSteps kOurSteps = StepsOf<TriangulatedPlace, OldestPastFrame, NearestDepths>();

// The scene of a static landmark observed in frames 1 to 3. With past_frames = 4, frame 0 is the
// exact past frame.
LabelScene SceneOfThreeFrames(const LabelSceneSteps& steps) {
  Moving m;
  LabelSceneOptions options;
  options.past_frames = 4;
  m.window.landmarks = {Moving::Seen(m.p_in_world, [&](std::int64_t) { return m.p_in_world; })};
  m.window.landmarks[0].p_in_object.z() += 0.5;
  std::erase_if(m.window.landmarks[0].observations,
                [](const Observation& seen) { return seen.frame == FrameId{0}; });
  m.Add(m.p_in_world, kSceneOwner, 0, kStaticScene);
  return m.With([&](const FrameView& view) {
    return BuildLabelScene(view, options, m.window, m.map, m.tracks, m.points, steps);
  });
}

TEST(BuildLabelScene, PastIsTheOldestFrameOrTheExactOne) {
  const auto oldest = SceneOfThreeFrames(kOurSteps).crf.nodes.at(0).past;
  ASSERT_TRUE(oldest);
  EXPECT_EQ(oldest->frame, 1);
  constexpr auto kExact = StepsOf<TriangulatedPlace, ExactPastFrame, NearestDepths>();
  EXPECT_FALSE(SceneOfThreeFrames(kExact).crf.nodes.at(0).past);
}

TEST(BuildLabelScene, LandmarkPositionIsTriangulatedOrEstimated) {
  EXPECT_FALSE(SceneOfThreeFrames(kOurSteps).crf.nodes.at(0).estimate);
  constexpr auto kOwn = StepsOf<EstimatedPlace, OldestPastFrame, NearestDepths>();
  const CrfNode node = SceneOfThreeFrames(kOwn).crf.nodes.at(0);
  ASSERT_TRUE(node.estimate);
  EXPECT_NEAR(node.estimate->p_in_camera.z(), node.p_in_camera.z() + 0.5, 1e-9);
  EXPECT_TRUE(node.estimate->covariance_m2.isZero());
}

TEST(BuildLabelScene, NonPositiveDisparitiesAreFarAway) {
  for (const double disparity_px : {0.0, -0.3}) {
    Moving m;
    m.window.landmarks = {Moving::Seen(m.p_in_world, [&](std::int64_t) { return m.p_in_world; })};
    m.Add(m.p_in_world, kSceneOwner, 0, kStaticScene);
    m.frame.features[0].z_px[2] = m.frame.features[0].z_px[0] - disparity_px;
    const LabelScene scene = m.With([&](const FrameView& view) {
      return BuildLabelScene(view, {}, m.window, m.map, m.tracks, m.points, kOurSteps);
    });
    const CrfNode& node = scene.crf.nodes.at(0);
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
  LabelSceneOptions options;
  options.extent.part_share = part_share;
  const LabelScene scene = m.With([&](const FrameView& view) {
    return BuildLabelScene(view, options, m.window, m.map, m.tracks, m.points, kOurSteps);
  });
  return scene.Outlier() - 1 - scene.clusters;
}

TEST(BuildLabelScene, ABoxInsideThatOfAClusterIsAPartOfIt) {
  EXPECT_EQ(NewBodiesInside("Car", 7.0, 0.8), 0);
  EXPECT_EQ(NewBodiesInside("Car", 20.0, 0.8), 1) << "far behind the body";
  EXPECT_EQ(NewBodiesInside("Pedestrian", 7.0, 0.8), 1) << "of another class";
  EXPECT_EQ(NewBodiesInside("Car", 7.0, 2.0), 1) << "the rule is off";
}

TEST(NewBodyPolicies, TakeTheNearestDepthsOrAllOfThem) {
  const std::vector<double> depths_m = {2.0, 2.01, 2.02, 2.0, 2.01, 9.0, 9.1};
  EXPECT_THAT(NearestDepths::Candidates(depths_m, 0.2, {}),
              ElementsAre(ElementsAre(0, 1, 2, 3, 4)));
  EXPECT_THAT(AllDepths::Candidates(depths_m, 0.2, {}), ElementsAre(SizeIs(7)));
  EXPECT_THAT(AllDepths::Candidates({2.0, 2.0, 2.0, 2.0}, 0.2, {}), IsEmpty());
}

// Two clusters exchange their labels, and the label of a third starts a new cluster.
TEST(NameLabels, BoxesFollowTheLabels) {
  LabelScene scene;
  scene.crf.labels.resize(5);
  scene.clusters = 3;
  scene.detection = {-1, 0, 1, 2, -1};
  scene.given_body.resize(5);
  ClusterMap map;
  map.live.resize(3);
  for (int q = 0; q < 3; ++q) map.live[q].id = ClusterId{q + 1};
  map.next = ClusterId{9};
  std::vector<ClusterId> cluster_of = {kStaticScene, ClusterId{2}, ClusterId{1}, kNone, kNone};
  FrameLabels labels;
  internal::NameLabels(map, scene, cluster_of, labels);
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
