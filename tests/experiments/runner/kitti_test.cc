// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests that boxes drawn in image_02 of a real drive move to image_00 by the depth of their
// features.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/task_pool.h"
#include "experiments/runner/frame_detections.h"
#include "experiments/runner/look_ahead.h"
#include "tests/support/real_data.h"

namespace cvo::kitti_test {
namespace {

// Both moving cars of drive_0013 are seen from behind: the visible face is half a length nearer
// than the centre of the labelled box.
TEST(KittiDetections, MoveByTheDepthOfTheNearFace) {
  const auto data = test::RealData();
  if (!data) GTEST_SKIP() << "CLUSTERVO_DATA does not name a folder with KITTI data";
  const auto labels = *data / "kitti_tracking/training/label_02/0003.txt";
  const Sequence sequence =
      OpenSequence({.folder = *data / "kitti_raw/2011_09_26/2011_09_26_drive_0013_sync",
                    .begin_frame = 42,
                    .end_frame = 48,
                    .detections_file = labels,
                    .detections_camera = 2});
  const BoxCamera camera = {sequence.camera, sequence.detections_offset_m};
  TaskPool pool(2);
  const Options options;
  LookAhead look_ahead(sequence, options, pool);
  int moved = 0;
  for (const std::vector<ObjectBox>& boxes : DetectionsByFrame(sequence)) {
    const PreparedFrame prepared = look_ahead.Next();
    for (const ObjectBox& drawn : boxes) {
      if (drawn.type != "Car" || drawn.occlusion > 0) continue;
      DetectionCounts counts;
      const auto given =
          DetectionsOfFrame({drawn}, camera, prepared.frame.features, RigidClasses(), counts);
      ASSERT_EQ(given.size(), 1U);
      const double face_m = drawn.box3d->bottom_in_camera.z() - 0.5 * drawn.box3d->length_m;
      const double shift_px = -camera.left.fx * camera.offset_m / face_m;
      EXPECT_NEAR(given[0].box.right_px, drawn.right_px + shift_px, 0.6) << drawn.frame;
      EXPECT_GT(std::abs(shift_px), 1.0);
      ++moved;
    }
  }
  EXPECT_GE(moved, 6);
}

}  // namespace
}  // namespace cvo::kitti_test
