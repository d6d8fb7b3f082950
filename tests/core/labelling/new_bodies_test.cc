// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests new bodies in boxes without a cluster, where one body partly occludes another.
#include "core/labelling/new_bodies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/labelling/labelled_frame.h"

namespace cvo::new_bodies_test {
namespace {

// A near body occludes the right half of a far one, of which only the left part is visible.
struct TwoBoxes {
  ImageBox near_box{300.0, 100.0, 400.0, 300.0};
  ImageBox far_box{200.0, 120.0, 360.0, 260.0};
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
  std::vector<double> Depths(const NewBodyRule& rule, double min_fill,
                             const std::vector<char>& is_claimed) const {
    const FeatureGrid grid(frame.features, test::kCamera);
    const FrameView view{frame, UseDetections::Show(frame), grid, test::kCamera, {}};
    ExtentOptions extent;
    extent.mode_min_fill = min_fill;
    std::vector<double> depths_m;
    for (const auto& body : FindNewBodies(view, {rule, extent, 0.0}, is_claimed, points, nodes)) {
      depths_m.push_back(body ? body->center_in_camera.z() : 0.0);
    }
    return depths_m;
  }
};

using ::testing::ElementsAre;

constexpr NewBodyRule kNearest = RuleOf<NearestDepths>();

TEST(FindNewBodies, OccludingBodyOwnsItsPointsExclusively) {
  EXPECT_THAT(TwoBoxes().Depths(kNearest, 0.0, {0, 0}), ElementsAre(4.0, 2.0));
}

TEST(FindNewBodies, DepthRangeMustFillTheBox) {
  TwoBoxes boxes;
  boxes.frame.detections.resize(1);
  EXPECT_THAT(boxes.Depths(kNearest, 0.0, {0}), ElementsAre(2.0));
  EXPECT_THAT(boxes.Depths(kNearest, 0.9, {0}), ElementsAre(4.0));
}

TEST(FindNewBodies, AllDepthsUsesEveryPointInTheBox) {
  EXPECT_THAT(TwoBoxes().Depths(RuleOf<AllDepths>(), 0.5, {0, 0}), ElementsAre(3.0, 2.0));
}

TEST(FindNewBodies, NoneIfAClusterClaimsTheBoxOrOwnsThePoints) {
  TwoBoxes boxes;
  EXPECT_THAT(boxes.Depths(kNearest, 0.0, {1, 0}), ElementsAre(0.0, 2.0));
  for (FramePoint& point : boxes.points) point.owner = ClusterOwner(0);
  EXPECT_THAT(boxes.Depths(kNearest, 0.0, {0, 0}), ElementsAre(0.0, 0.0));
}

}  // namespace
}  // namespace cvo::new_bodies_test
