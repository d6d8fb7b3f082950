// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/plausibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "experiments/datasets/sequence.h"
#include "tests/support/error_message.h"

namespace cvo {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Plausibility, ReportsBaselinesInTheWrongUnitAndJumpsOfTheCamera) {
  Sequence sequence;
  sequence.camera.baseline_m = 120.0;
  sequence.timestamps_ns = {0, 100'000'000, 200'000'000};
  sequence.groundtruth_world_from_camera.assign(3, RigidTransform());
  EXPECT_THAT(FindImplausible(sequence), ElementsAre(HasSubstr("a baseline of 120 m")));
  sequence.camera.baseline_m = 0.54;
  EXPECT_THAT(FindImplausible(sequence), IsEmpty());
  sequence.groundtruth_world_from_camera[1] =
      RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(50.0, 0.0, 0.0));
  EXPECT_THAT(FindImplausible(sequence),
              ElementsAre(AllOf(HasSubstr("frame 1: 50 m"), HasSubstr("1 more"))));
}

// One row per kind: what is done to a good sequence, and what is said. Refused: "!" first.
TEST(Plausibility, TellsEachKindOfNonsense) {
  Sequence good;
  good.camera = StereoCamera{500.0, 500.0, 320.0, 240.0, 0.12, 640, 480};
  good.images.resize(20);
  good.groundtruth_world_from_camera.resize(20);
  for (int i = 0; i < 20; ++i) {
    good.timestamps_ns.push_back(100'000'000LL * i);
    ObjectBox box;
    box.frame = i;
    box.left_px = box.top_px = 100.0;
    box.right_px = box.bottom_px = 300.0;
    good.detections.push_back(box);
    box.box3d = {1.0, 1.0, 1.0, {-0.5, 0.3, 2.0}, 0.0};
    good.labels.push_back(box);
  }
  const auto scale_boxes = [](double factor) {
    return [factor](Sequence& s) {
      for (ObjectBox& box : s.detections) {
        box.left_px *= factor;
        box.top_px *= factor;
        box.right_px *= factor;
        box.bottom_px *= factor;
      }
    };
  };
  const auto scale_times = [](double factor) {
    return [factor](Sequence& s) {
      for (std::int64_t& time_ns : s.timestamps_ns) {
        time_ns = static_cast<std::int64_t>(factor * static_cast<double>(time_ns));
      }
    };
  };
  const auto spoil_label = [](auto spoil) { return [spoil](Sequence& s) { spoil(s.labels[3]); }; };
  struct Case {
    std::function<void(Sequence&)> spoil;
    std::string message;
    std::size_t repeated = 0;
  };
  for (const Case& c :
       {Case{[](Sequence&) {}, ""}, Case{[](Sequence&) {}, "", 1},
        Case{[](Sequence&) {}, "images: 15 of 20 frames repeat", 15},
        Case{[](Sequence& s) { s.camera.baseline_m = 0.001; }, "a baseline of "},
        Case{scale_times(20.0), "times: a median of 2 s per frame"},
        Case{scale_times(1e-3), "!times: found a median of "},
        Case{scale_boxes(2.0), "detections: 20 of 20 boxes end beyond the image of 640x480 px"},
        Case{scale_boxes(1.0 / 640.0), "!boxes in pixels"},
        Case{scale_boxes(0.78), "detections: all 20 boxes lie in the upper left quarter"},
        Case{[](Sequence& s) { s.detections[3].frame = s.detections[5].frame = 4; },
             "detections: 2 of 20 boxes repeat another one"},
        Case{spoil_label([](ObjectBox& box) { box.occlusion = 7; }),
             "labels, frame 3: occlusion 7, where -1 to 3 are defined"},
        Case{spoil_label([](ObjectBox& box) { box.truncation = 50.0; }), "truncation 50"},
        Case{spoil_label([](ObjectBox& box) { box.box3d->heading_rad = 90.0; }), "heading 90"},
        Case{[](Sequence& s) {
               for (ObjectBox& box : s.labels) box.box3d->bottom_in_camera.x() += 4.0;
             },
             "labels: of 20 boxes in 3D, 20 have their centre beside"}}) {
    Sequence sequence = good;
    c.spoil(sequence);
    const std::string refused = ErrorMessage([&] { RefuseImpossible(sequence); });
    if (c.message.starts_with('!')) {
      EXPECT_THAT(refused, HasSubstr(c.message.substr(1)));
      continue;
    }
    EXPECT_EQ(refused, "");
    const std::vector<std::string> lines = FindImplausible(sequence, c.repeated);
    ASSERT_EQ(lines.size(), c.message.empty() ? 0U : 1U) << c.message;
    if (!lines.empty()) {
      EXPECT_THAT(lines[0], HasSubstr(c.message));
    }
  }
}

}  // namespace
}  // namespace cvo
