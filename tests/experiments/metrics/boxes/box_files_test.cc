// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "experiments/metrics/boxes/average_precision.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::ap_files_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kObject = "Car 0.5 1 0 10 20 60 80 1.5 1.6 3.9 1 2 30 0.1";

class ApFiles : public testing::Test {
 protected:
  void ExpectError(const std::string& labels, const std::string& detections,
                   const std::string& text) const {
    EXPECT_THAT(ErrorMessage([&] {
                  CheckScores(
                      ReadApFrames(folder_.path() / labels, folder_.path() / detections, {}), "");
                }),
                testing::HasSubstr(text));
  }

  test::TempFolder folder_;
};

TEST_F(ApFiles, ReadsTrackingFiles) {
  folder_.Write("labels.txt", std::string("2 7 ") + kObject + "\n");
  folder_.Write("rows.txt", std::string("0 1 ") + kObject + " 0.3\n3 1 " + kObject + " 0.4\n");
  const auto frames =
      ReadApFrames(folder_.path() / "labels.txt", folder_.path() / "rows.txt", {1, -1});
  ASSERT_EQ(frames.size(), 2U);  // frames 2 and 3
  ASSERT_EQ(frames[0].labels.size(), 1U);
  EXPECT_EQ(frames[0].labels[0].truncation, 0.5);
  EXPECT_EQ(frames[0].labels[0].box3d->bottom_in_camera.z(), 30.0);
  ASSERT_EQ(frames[1].detections.size(), 1U);
  EXPECT_EQ(frames[1].detections[0].score, 0.4);
}

TEST_F(ApFiles, ReadsObjectFolders) {
  folder_.Write("labels/000004.txt", std::string(kObject) + "\n");
  folder_.Write("labels/000009.txt", "");
  folder_.Write("rows/000004.txt", std::string(kObject) + " -2.5\n");
  const auto frames = ReadApFrames(folder_.path() / "labels", folder_.path() / "rows", {});
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].labels[0].occlusion, 1);
  EXPECT_EQ(frames[0].detections[0].score, -2.5);
  EXPECT_TRUE(frames[1].detections.empty());
}

TEST_F(ApFiles, BadInput) {
  folder_.Write("labels/000004.txt", std::string(kObject) + "\n");
  folder_.Write("rows/000005.txt", std::string(kObject) + " 1\n");
  ExpectError("labels", "rows", "000005.txt: found detections of image 5");
  folder_.Write("rows.txt", std::string("0 1 ") + kObject + "\n");
  ExpectError("labels", "rows.txt", "found a file, expected a folder, as");
  folder_.Write("short/000004.txt", "Car 0 0\n");
  ExpectError("labels", "short", "000004.txt:1: found 3 columns");
  folder_.Write("one/1.txt", std::string(kObject) + "\n");
  folder_.Write("one/01.txt", std::string(kObject) + "\n");
  ExpectError("one", "one", "found number 1 a second time");
  folder_.Write("two/1.txt", std::string(kObject) + " 1\n");
  folder_.Write("two/2.txt", std::string(kObject) + "\n");
  ExpectError("two", "two", "found scores of 1 of 2 detections");
  ExpectError("nothing.txt", "rows.txt", "nothing.txt");
  const fs::path twice = folder_.Write(
      "twice.txt", StrCat("0 1 ", kObject, "\n1.00 2.00 ", kObject, "\n1 2 ", kObject));
  EXPECT_EQ(ReadApFrames(twice.parent_path() / "rows.txt", twice, {}).size(), 2U);
  EXPECT_THAT(
      ErrorMessage([&] { ReadApFrames(twice.parent_path() / "rows.txt", twice, {}, true); }),
      testing::HasSubstr("twice.txt:3: found track 2 of frame 1 a second time"));
  std::filesystem::create_directory(folder_.path() / "empty");
  ExpectError("empty", "empty", "no <number>.txt");
}

TEST_F(ApFiles, OtherFilesOfAFolderAreIgnored) {
  folder_.Write("labels/0.txt", std::string(kObject) + "\n");
  folder_.Write("labels/-1.txt", "no label");
  folder_.Write("labels/1.png", "no label");
  folder_.Write("labels/notes.txt", "no label");
  folder_.Write("rows/0.txt", std::string(kObject) + "\n" + kObject + "\n");
  const auto frames = ReadApFrames(folder_.path() / "labels", folder_.path() / "rows", {});
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].labels.at(0).frame, 0);
  EXPECT_EQ(frames[0].detections.size(), 2U) << "none has a score, which is all of them";
}

}  // namespace
}  // namespace cvo::ap_files_test

namespace cvo::box_metrics_test {
namespace {

// A car of 4 x 2 x 1.5 m at x, in frame 7, the first of two frames.
ObjectBox CarAt(double x, double height_px) {
  ObjectBox box;
  box.frame = 7;
  box.type = "Car";
  box.truncation = 0.0;
  box.occlusion = 0;
  box.right_px = 80.0;
  box.bottom_px = height_px;
  box.box3d = ObjectBox::Box3d{1.5, 2.0, 4.0, {x, 1.6, 20.0}, 0.0};
  return box;
}

Sequence Labelled(const std::vector<ObjectBox>& labels) {
  Sequence sequence;
  sequence.first_frame = 7;
  sequence.images.resize(2);
  sequence.labels = labels;
  return sequence;
}

ObjectBox Scored(ObjectBox box, double score) {
  box.score = score;
  return box;
}

// An IoU of exactly 1/4 is not enough: at an offset of 2.4 m, boxes of 4 m share 1.6 of 6.4 m.
TEST(BoxMetrics, CountBoxesThatOverlapByMoreThanAQuarter) {
  const Sequence sequence = Labelled({CarAt(0.0, 50.0)});
  const auto metrics = BoxMetrics(sequence, {Scored(CarAt(2.3, 50.0), 0.4)});
  ASSERT_EQ(metrics.size(), 6U);
  EXPECT_EQ(metrics[0].name, "box_ap_bv_easy");
  EXPECT_EQ(metrics[4].name, "box_ap_3d_moderate");
  for (const Metric& metric : metrics) {
    EXPECT_EQ(metric.value, 1.0) << metric.name;
    EXPECT_EQ(metric.n, 1);
    EXPECT_EQ(metric.contract.subject, reports::Subject::kCars);
  }
  for (const Metric& metric : BoxMetrics(sequence, {Scored(CarAt(2.5, 50.0), 0.4)})) {
    EXPECT_EQ(metric.value, 0.0) << metric.name;
  }
}

TEST(BoxMetrics, AreAbsentWithoutLabelsOfTheirLevel) {
  const auto metrics = BoxMetrics(Labelled({CarAt(0.0, 30.0)}), {});  // too small to be easy
  ASSERT_EQ(metrics.size(), 4U);
  EXPECT_EQ(metrics[0].name, "box_ap_bv_moderate");
  EXPECT_EQ(metrics[0].value, 0.0);
  ObjectBox van = CarAt(0.0, 50.0);
  van.type = "Van";
  EXPECT_TRUE(BoxMetrics(Labelled({van}), {Scored(CarAt(0.0, 50.0), 1.0)}).empty());
}

}  // namespace
}  // namespace cvo::box_metrics_test
