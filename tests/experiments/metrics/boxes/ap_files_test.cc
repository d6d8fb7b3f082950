// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "experiments/metrics/boxes/average_precision.h"
#include "tests/support/temp_folder.h"

namespace cvo::ap_files_test {
namespace {

constexpr const char* kObject = "Car 0.5 1 0 10 20 60 80 1.5 1.6 3.9 1 2 30 0.1";

class ApFiles : public testing::Test {
 protected:
  void ExpectError(const std::string& labels, const std::string& detections,
                   const std::string& text) const {
    try {
      ReadApFrames(folder_.path() / labels, folder_.path() / detections, {});
      ADD_FAILURE() << "no error: " << text;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(text));
    }
  }

  test::TempFolder folder_;
};

TEST_F(ApFiles, ReadsTrackingFiles) {
  folder_.Write("labels.txt", std::string("2 7 ") + kObject + "\n");
  folder_.Write("rows.txt", std::string("0 1 ") + kObject + " 0.3\n3 1 " + kObject + " 0.4\n");
  const auto frames =
      ReadApFrames(folder_.path() / "labels.txt", folder_.path() / "rows.txt", {1, -1});
  ASSERT_EQ(frames.size(), 3U);  // frames 1, 2 and 3
  ASSERT_EQ(frames[1].labels.size(), 1U);
  EXPECT_EQ(frames[1].labels[0].truncation, 0.5);
  EXPECT_EQ(frames[1].labels[0].box3d->bottom_in_camera.z(), 30.0);
  ASSERT_EQ(frames[2].detections.size(), 1U);
  EXPECT_EQ(frames[2].detections[0].score, 0.4);
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
  ExpectError("one", "one", "found a second file of image 1");
  folder_.Write("two/1.txt", std::string(kObject) + " 1\n");
  folder_.Write("two/2.txt", std::string(kObject) + "\n");
  ExpectError("two", "two", "found scores of 1 of 2 detections");
  ExpectError("nothing.txt", "rows.txt", "nothing.txt");
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

TEST_F(ApFiles, ImagesAreOrderedByNumber) {
  folder_.Write("labels/9.txt", std::string(kObject) + "\n");
  folder_.Write("labels/10.txt", std::string(kObject) + "\n" + kObject + "\n");
  folder_.Write("rows/10.txt", std::string(kObject) + " 1\n");
  const auto frames = ReadApFrames(folder_.path() / "labels", folder_.path() / "rows", {});
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[1].labels.size(), 2U);
  EXPECT_EQ(frames[1].labels[1].frame, 1);
  EXPECT_EQ(frames[1].detections.at(0).frame, 1);
}

TEST_F(ApFiles, TrackingFilesEndWithTheLastRowOfEither) {
  folder_.Write("none.txt", "");
  folder_.Write("first.txt", std::string("0 1 ") + kObject + "\n");
  const auto frames = ReadApFrames(folder_.path() / "none.txt", folder_.path() / "first.txt", {});
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_TRUE(frames[0].labels.empty());
  EXPECT_EQ(frames[0].detections.size(), 1U);
  EXPECT_EQ(ReadApFrames(folder_.path() / "first.txt", folder_.path() / "none.txt", {}).size(), 1U);
}

}  // namespace
}  // namespace cvo::ap_files_test
