// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "experiments/datasets/plausibility.h"

namespace cvo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A box that moves to the right by 8 px in each frame, as the corners in it do.
TEST(Plausibility, ComparesBoxesWithThoseOfOtherFrames) {
  const auto lines = [](const std::function<int(int)>& place_of) {
    std::vector<ObjectBox> boxes(20);
    std::vector<SeenFrame> frames(19);
    for (int i = 0; i < 20; ++i) {
      ObjectBox& box = boxes[static_cast<std::size_t>(i)];
      box.type = "Car";
      box.frame = i;
      box.left_px = 8.0 * place_of(i), box.right_px = box.left_px + 50.0;
      box.top_px = 100.0, box.bottom_px = 150.0;
      if (i == 19) break;
      SeenFrame& seen = frames[static_cast<std::size_t>(i)];
      seen.frame = i, seen.later = i + 1;
      for (double x = 0.0; x < 500.0; x += 10.0)
        seen.moves.push_back({{x, 120.0}, {x + 8.0, 120.0}});
    }
    std::vector<std::string> found;
    FindMisplaced({}, frames, "detections", boxes, found);
    return found;
  };
  EXPECT_THAT(lines([](int i) { return i; }), IsEmpty());
  EXPECT_THAT(lines([](int i) { return 19 - i; }),
              ElementsAre(HasSubstr("detections: boxes that follow the images share ")));
  EXPECT_THAT(
      lines([](int i) { return 7 * i % 20; }),
      ElementsAre(HasSubstr("detections: boxes share 0 % with those of the next frame, 72 % "
                            "with those 3 frames later")));
}

// A floor that is nearer the lower it is seen, and a body that stands on it on the left.
TEST(Plausibility, ComparesBoxesWithDepths) {
  Sequence good;
  good.camera.width_px = 320;
  good.camera.height_px = 240;
  std::vector<SeenFrame> frames(12);
  for (int i = 0; i < 12; ++i) {
    ObjectBox box;
    box.type = "Car";
    box.frame = frames[static_cast<std::size_t>(i)].frame = i;
    box.left_px = 40.0, box.right_px = 90.0, box.top_px = 130.0, box.bottom_px = 180.0;
    good.detections.push_back(box);
    for (double v = 5.0; v < 240.0; v += 10.0) {
      for (double u = 5.0; u < 320.0; u += 10.0) {
        const bool body = u > 40.0 && u < 90.0 && v > 130.0 && v < 180.0;
        const double disparity_px = body ? 20.0 : 0.1 * v;
        frames[static_cast<std::size_t>(i)].points.emplace_back(u, v, disparity_px);
      }
    }
  }
  struct Case {
    std::function<void(ObjectBox&)> spoil;
    std::string message;
  };
  const auto turn = [](double& low, double& high, double size) {
    low = size - std::exchange(high, size - low);
  };
  for (const Case& c :
       {Case{[](ObjectBox&) {}, ""},
        Case{[&](ObjectBox& b) { turn(b.left_px, b.right_px, 320.0); }, "if they were mirrored"},
        Case{[&](ObjectBox& b) { turn(b.top_px, b.bottom_px, 240.0); }, "if they were upside down"},
        Case{[](ObjectBox& b) { b.left_px += 30.0, b.right_px += 30.0; },
             "if they were farther left"},
        Case{[](ObjectBox& b) { b.top_px = 5.0, b.bottom_px = 45.0; }, "in only 50 % of"},
        Case{[](ObjectBox& b) {
               b.top_px *= 0.8, b.bottom_px *= 0.8, b.left_px *= 0.8, b.right_px *= 0.8;
             },
             "if they were scaled by 5/4"}}) {
    Sequence sequence = good;
    for (ObjectBox& box : sequence.detections) c.spoil(box);
    std::vector<std::string> lines;
    FindMisplaced(sequence, frames, "detections", sequence.detections, lines);
    ASSERT_EQ(lines.size(), c.message.empty() ? 0U : 1U) << c.message;
    if (!lines.empty()) {
      EXPECT_THAT(lines[0], HasSubstr(c.message));
    }
  }
  // Nearer bodies beside it that the image cuts off are not what is around it.
  for (const double left_px : {-10.0, 90.0}) {
    for (int i = 0; i < 12; ++i) {
      ObjectBox box = good.detections[static_cast<std::size_t>(i)];
      box.left_px = left_px, box.right_px = left_px + 50.0, box.truncation = 0.5;
      good.detections.push_back(box);
      for (Eigen::Vector3d& point : frames[static_cast<std::size_t>(i)].points) {
        const bool inside = std::abs(point.x() - box.left_px - 25.0) < 25.0;
        if (inside && point.y() > 130.0 && point.y() < 180.0) point.z() = 40.0;
      }
    }
  }
  std::vector<std::string> lines;
  FindMisplaced(good, frames, "detections", good.detections, lines);
  EXPECT_THAT(lines, IsEmpty());
}

}  // namespace
}  // namespace cvo
