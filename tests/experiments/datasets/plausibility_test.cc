// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/plausibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/rng.h"
#include "core/files/images/image_file.h"
#include "experiments/datasets/sequence.h"
#include "tests/support/error_message.h"
#include "tests/support/image_file.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

using testing::HasSubstr;

// One row per kind: what is done to a good sequence, and what is said. Refused: "!" first.
TEST(Plausibility, TellsEachKindOfNonsense) {
  Sequence good;
  good.camera = StereoCamera{500.0, 500.0, 320.0, 240.0, 0.12, 640, 480};
  good.images.resize(20);
  good.groundtruth_world_from_camera.resize(20);
  for (int i = 0; i < 20; ++i) {
    good.timestamps_ns.push_back(100'000'000LL * i);
    ObjectBox box;
    box.type = "Car";
    box.frame = i;
    box.left_px = box.top_px = 100.0;
    box.right_px = box.bottom_px = 300.0;
    good.detections.push_back(box);
    box.type = "Van";
    box.box3d = {0.8, 0.1, 0.8, {-0.5, 0.3, 2.0}, 0.0};
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
  const auto cut_boxes = [](double first_px) {
    return [first_px](Sequence& s) {
      for (ObjectBox& box : s.detections) box.left_px = first_px, box.right_px = first_px + 639.0;
    };
  };
  const test::TempFolder empty;
  std::ofstream(empty.path() / "none.txt");
  struct Case {
    std::function<void(Sequence&)> spoil;
    std::string message;
    std::size_t repeated = 0;
  };
  for (const Case& c :
       {Case{[](Sequence&) {}, ""},
        Case{[](Sequence&) {}, "", 1},
        Case{[&](Sequence& s) { s.box_sources.labels = empty.path() / "none.txt"; },
             "none.txt is empty"},
        Case{[](Sequence&) {}, "images: 15 of 20 frames repeat", 15},
        Case{[](Sequence& s) { s.camera.baseline_m = 0.001; }, "a baseline of "},
        Case{[](Sequence& s) { s.camera.baseline_m = 120.0; }, "a baseline of 120 m"},
        Case{[](Sequence& s) { s.camera.fx = s.camera.fy = 4.0, s.labels.clear(); },
             "calibration: fx 4, fy 4"},
        Case{[](Sequence& s) {
               s.groundtruth_world_from_camera.assign(20, RigidTransform());
               s.groundtruth_world_from_camera[1] =
                   RigidTransform(Eigen::Quaterniond::Identity(), {50.0, 0.0, 0.0});
             },
             "frame 1: 50 m from the one before, 0.1 s earlier, and 1 more like it"},
        Case{[](Sequence& s) {
               for (int i = 0; i < 20; ++i) {
                 s.groundtruth_world_from_camera[static_cast<std::size_t>(i)] = RigidTransform(
                     Eigen::Quaterniond::Identity(), {0.1 * i + (i < 9 ? 0 : 1), 0.0, 0.0});
               }
             },
             "frame 9: 1.1 m from the one before, 0.1 s earlier"},
        Case{[](Sequence& s) {  // a truth that is known of two frames in five
               for (int i = 0; i < 20; ++i) {
                 auto& pose = s.groundtruth_world_from_camera[static_cast<std::size_t>(i)];
                 if (i % 5 < 2)
                   pose = RigidTransform(Eigen::Quaterniond::Identity(), {0.5 * i, 0.0, 0.0});
               }
             },
             ""},
        Case{[](Sequence& s) {
               for (std::size_t i = 0; i < 20; i += 2) s.timestamps_ns[i] += 40'000'000;
             },
             "times: intervals differ by "},
        Case{[](Sequence& s) {
               for (ObjectBox& box : s.labels) box.track = box.frame;
             },
             "labels: 20 boxes have 20 track ids"},
        Case{[](Sequence& s) { std::swap(s.camera.cx, s.camera.cy), s.labels.clear(); },
             "calibration: fx 500, fy 500, cx 240, cy 320 px of a 640x480"},
        Case{[](Sequence& s) {
               for (int i = 0; i < 20; ++i) {
                 s.groundtruth_world_from_camera[static_cast<std::size_t>(i)] =
                     RigidTransform(Eigen::Quaterniond::Identity(), {0.0, 0.0, 8.0 * i});
               }
             },
             "ground truth of the camera: a median speed of 80 m/s"},
        Case{[](Sequence& s) { s.camera.fx = 800.0, s.labels.clear(); },
             "calibration: fx 800, fy 500, cx 320, cy 240 px of a 640x480"},
        Case{scale_times(20.0), "times: a median of 2 s per frame"},
        Case{scale_times(1e-3), "!times: found a median of "},
        Case{scale_boxes(2.0), "detections: 20 of 20 boxes end beyond the image of 640x480 px"},
        Case{scale_boxes(1.0 / 640.0), "!boxes in pixels"},
        Case{scale_boxes(0.78), "detections: all 20 boxes lie in the upper left quarter"},
        Case{[](Sequence& s) { s.detections[3].frame = s.detections[5].frame = 4; },
             "detections: 2 of 20 boxes repeat another one"},
        Case{[](Sequence& s) {
               for (ObjectBox& box : s.detections) box.top_px += std::exchange(box.frame, 4);
             },
             "detections: all 20 boxes are of frame 4"},
        Case{spoil_label([](ObjectBox& box) { box.occlusion = 7; }),
             "labels, frame 3: occlusion 7, where -1 to 3 are defined"},
        Case{spoil_label([](ObjectBox& box) { box.truncation = 50.0; }), "truncation 50"},
        Case{spoil_label([](ObjectBox& box) { box.box3d->heading_rad = 90.0; }), "heading 90"},
        Case{[](Sequence& s) {
               for (ObjectBox& box : s.labels) box.box3d->bottom_in_camera.x() += 4.0;
             },
             "labels: three of four boxes in 3D share less than 0 %"},
        Case{[](Sequence& s) {
               for (ObjectBox& box : s.labels) box.box3d->bottom_in_camera *= 0.5;
             },
             "labels: three of four boxes in 3D share less than 31 %"},
        Case{[](Sequence& s) {
               for (ObjectBox& box : s.detections) box.right_px = box.left_px;
             },
             "detections: 20 of 20 boxes are without extent"},
        Case{[](Sequence& s) {
               for (ObjectBox& box : s.detections) box.right_px = 200.0;
             },
             "detections: 20 of 20 boxes are without the shape of a car or a person"},
        Case{[](Sequence& s) {
               for (ObjectBox& box : s.detections) box.type = "-1";
             },
             "detections: 20 of 20 boxes are without a class name"},
        Case{cut_boxes(0.0), ""},
        Case{cut_boxes(1.0), "20 boxes begin at 1 and 20 end at 640"}}) {
    Sequence sequence = good;
    c.spoil(sequence);
    const std::string refused = ErrorMessage([&] { RefuseImpossible(sequence); });
    if (c.message.starts_with('!')) {
      EXPECT_THAT(refused, HasSubstr(c.message.substr(1)));
      continue;
    }
    EXPECT_EQ(refused, "");
    const std::vector<std::string> lines = FindImplausible(sequence, c.repeated);
    ASSERT_EQ(lines.size(), c.message.empty() ? 0U : 1U) << testing::PrintToString(lines);
    if (!lines.empty()) {
      EXPECT_THAT(lines[0], HasSubstr(c.message));
    }
  }
}

// A camera that moves up and a little to the left while it rolls, 2 m in front of a wall of random
// dots.
TEST(Plausibility, ComparesImagesWithEverythingElse) {
  constexpr double kFocal_px = 300.0, kDepth_m = 2.0, kDisparity_px = 15.0;
  const cv::Size size(320, 240);
  constexpr double kRoll_rad = 0.15;         // per frame
  const Eigen::Vector2d step_px(1.0, 10.0);  // of points
  cv::Mat dots(size.height * 2, size.width * 2, CV_8UC1, cv::Scalar(90));
  Rng rng(1, "dots");
  for (int i = 0; i < 1500; ++i) {
    const cv::Point at(static_cast<int>(rng.Uniform(0.0, dots.cols)),
                       static_cast<int>(rng.Uniform(0.0, dots.rows)));
    cv::circle(dots, at, 2 + i % 4, cv::Scalar(i * 37 % 256), -1, cv::LINE_AA);
  }
  const test::TempFolder folder;
  Sequence good;
  good.camera = StereoCamera{
      kFocal_px, kFocal_px, 160.0, 120.0, kDisparity_px * kDepth_m / kFocal_px, 320, 240};
  good.folder = folder.path();
  for (int i = 0; i < 8; ++i) {
    const auto write = [&](const char* side, double disparity_px) {
      const Eigen::Rotation2Dd roll(i * kRoll_rad);
      const Eigen::Vector2d centre(160.0, 120.0);
      const Eigen::Vector2d at = Eigen::Vector2d(80.0, 100.0) + centre - i * step_px +
                                 roll * Eigen::Vector2d(disparity_px, 0.0);
      const Eigen::Matrix2d back = roll.inverse().toRotationMatrix();
      const Eigen::Vector2d by = centre - back * at;
      const cv::Mat move = (cv::Mat_<double>(2, 3) << back(0, 0), back(0, 1), by.x(), back(1, 0),
                            back(1, 1), by.y());
      cv::Mat image;
      cv::warpAffine(dots, image, move, size);
      const auto path = folder.path() / StrCat(side, i, ".png");
      test::WriteImageFile(path, image);
      return path;
    };
    const auto left = write("left", 0.0);
    good.images.push_back({left, write("right", kDisparity_px)});
    good.timestamps_ns.push_back(100'000'000LL * i);
    const Eigen::Vector2d moved_m = -i * step_px * kDepth_m / kFocal_px;
    good.groundtruth_world_from_camera.push_back(RigidTransform(
        Eigen::Quaterniond(Eigen::AngleAxisd(i * kRoll_rad, Eigen::Vector3d::UnitZ())),
        Eigen::Vector3d(moved_m.x(), moved_m.y(), 0.0)));
  }
  const auto scale_truth = [](double x, double y) {
    return [x, y](Sequence& s) {
      for (auto& pose : s.groundtruth_world_from_camera) {
        const Eigen::Vector3d at = pose->translation().cwiseProduct(Eigen::Vector3d(x, y, 1.0));
        pose = RigidTransform(pose->rotation(), at);
      }
    };
  };
  // A disc at other places, one per frame.
  const auto discs = [&](const std::vector<int>& places) {
    return [&folder, places](Sequence& s) {
      const cv::Mat still = ReadImageFile(s.images[0].left, cv::IMREAD_GRAYSCALE);
      const auto right = s.images[0].right;
      s.images.clear();
      for (const int place : places) {
        cv::Mat image = still.clone();
        cv::circle(image, {30 + 24 * place, 120}, 50, cv::Scalar(255), -1);
        s.images.push_back({folder.path() / StrCat("disc", place, ".png"), right});
        test::WriteImageFile(s.images.back().left, image);
      }
      s.groundtruth_world_from_camera.assign(places.size(), std::nullopt);
    };
  };
  struct Case {
    std::function<void(Sequence&)> spoil;
    std::string message;
  };
  for (const Case& c :
       {Case{[](Sequence&) {}, ""},
        Case{[&](Sequence& s) {
               const cv::Mat dark = cv::Mat(size, CV_8UC1, cv::Scalar(15));
               for (StereoPaths& paths : s.images) paths.left = folder.path() / "dark.png";
               test::WriteImageFile(s.images[0].left, dark);
             },
             "images: 7 of 7 looked at are nearly black or show no corner"},
        Case{[&](Sequence& s) {
               for (std::size_t i = 0; i < s.images.size(); ++i) {
                 const cv::Mat sharp = ReadImageFile(s.images[i].left, cv::IMREAD_GRAYSCALE);
                 cv::Mat blurred;
                 cv::GaussianBlur(sharp, blurred, {}, 7.0);
                 s.images[i].left = folder.path() / StrCat("blurred", i, ".png");
                 test::WriteImageFile(s.images[i].left, blurred);
               }
             },
             "images: 7 of 7 looked at show few corners"},
        Case{discs({1, 0, 3, 2, 5, 4}), "images: in 3 of 3 places, four frames in a row would"},
        Case{discs({1, 3, 5, 7, 9, 11, 0, 2, 4, 6, 8, 10}),
             "images: 10 of 10 frames are more like one elsewhere"},
        Case{discs({0, 1, 2, 3, 9, 10, 11, 12}), "images, frame 4: it differs from the one before"},
        Case{discs({0, 1, 10, 11, 2, 3, 4, 5, 6, 7, 8, 9}),
             "images: 4 of 10 frames are more like one elsewhere"},
        Case{discs({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}), ""},
        Case{scale_truth(0.8, 0.8), "ground truth of the camera: points move by "},
        Case{scale_truth(1.0, -1.0), "ground truth of the camera: points move by 14.3"},
        Case{scale_truth(2.0, 2.0), "ground truth of the camera: points move by 14.3"},
        Case{[](Sequence& s) { s.camera.baseline_m *= 0.2; }, "wrong baseline"},
        Case{[](Sequence& s) { s.camera.baseline_m *= 0.02; }, "a median depth of 0.04"},
        Case{[](Sequence& s) {
               for (StereoPaths& paths : s.images) std::swap(paths.left, paths.right);
             },
             "in 7 of 7 places, left and right seem to be swapped"},
        Case{[](Sequence& s) {  // a floor, seen from below
               const cv::Mat left = ReadImageFile(s.images[0].left, cv::IMREAD_GRAYSCALE);
               cv::Mat right = cv::Mat::zeros(left.size(), left.type());
               for (int v = 0; v < left.rows; ++v) {
                 const int disparity_px = 30 - v / 12;
                 left.row(v)
                     .colRange(disparity_px, left.cols)
                     .copyTo(right.row(v).colRange(0, left.cols - disparity_px));
               }
               test::WriteImageFile(s.folder / "floor.png", right);
               for (StereoPaths& paths : s.images) {
                 paths = {s.images[0].left, s.folder / "floor.png"};
               }
               s.groundtruth_world_from_camera.assign(s.images.size(), std::nullopt);
             },
             "what is below is farther than what is above"},
        Case{[](Sequence& s) {
               for (StereoPaths& paths : s.images) paths.right = paths.left;
             },
             "in 7 of 7 places, the left and right images are the same"},
        Case{[](Sequence& s) {  // what the left images leave out
               for (std::size_t i = 0; i < s.images.size(); ++i) {
                 cv::Mat image;
                 cv::flip(ReadImageFile(s.images[i].left, cv::IMREAD_GRAYSCALE), image, 1);
                 const auto path = s.folder / StrCat("other", i, ".png");
                 test::WriteImageFile(path, image);
                 s.images[i].right = path;
               }
             },
             "the left and right images show nothing in common"},
        Case{[](Sequence& s) {
               for (std::size_t i = 1; i < s.images.size(); ++i) {
                 s.images[i - 1].right = s.images[i].right;
               }
             },
             "in 6 of 7 places, rows differ by 9"},
        Case{[](Sequence& s) {
               for (std::size_t i = 4; i < 6; ++i) s.images[i].right = s.images[i + 2].right;
             },
             "in 2 of 7 places, points lie more than 1 px apart"}}) {
    Sequence sequence = good;
    c.spoil(sequence);
    std::vector<std::string> lines;
    FindInImages(sequence, 0.1, 1, lines);
    ASSERT_EQ(lines.size(), c.message.empty() ? 0U : 1U)
        << c.message << testing::PrintToString(lines);
    if (!lines.empty()) {
      EXPECT_THAT(lines[0], HasSubstr(c.message));
    }
  }
}

}  // namespace
}  // namespace cvo
