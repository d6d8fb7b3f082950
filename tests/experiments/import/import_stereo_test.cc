// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/import/import_stereo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/datasets/sequence.h"
#include "experiments/import/import_cache.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

class ImportStereoTest : public testing::Test {
 protected:
  ImportStereoTest() {
    request_.left = folder_.path() / "kitchen" / "left";
    request_.right = folder_.path() / "kitchen" / "right";
    request_.calibration =
        folder_.Write("cam.yaml", "fx: 50\nfy: 50\ncx: 32\ncy: 24\nbaseline_m: 0.1\n");
  }
  // Images of one grey level each.
  void WriteImages(const std::vector<std::string>& names, const cv::Size& size = {64, 48}) const {
    for (const fs::path& side : {request_.left, request_.right}) {
      fs::create_directories(side);
      for (std::size_t i = 0; i < names.size(); ++i) {
        cv::imwrite((side / names[i]).string(),
                    cv::Mat(size, CV_8UC3, cv::Scalar::all(10.0 * static_cast<double>(i + 1))));
      }
    }
  }
  ImportOutcome Import() const {
    return ImportStereo(request_, out(), [](std::size_t, std::size_t) {});
  }
  void ExpectError(const std::string& text) const {
    try {
      Import();
      ADD_FAILURE() << "no error: " << text;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(text));
    }
    EXPECT_FALSE(fs::exists(out()));
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      EXPECT_EQ(entry.path().string().find(".tmp-"), std::string::npos);
    }
  }
  fs::path out() const { return folder_.path() / "out"; }

  test::TempFolder folder_;
  StereoImport request_;
};

// Files of any format whose names are numbers of any length, sorted by number.
TEST_F(ImportStereoTest, ASequenceThatCanBeOpened) {
  WriteImages({"9.jpg", "10.png", "11.bmp"});
  request_.rate_hz = 20.0;
  const ImportOutcome outcome = Import();
  EXPECT_EQ(outcome.frames, 3U);
  EXPECT_FALSE(outcome.rectified);
  EXPECT_STREQ(outcome.times, "rate");
  const Sequence sequence = OpenSequence({.folder = out()});
  EXPECT_EQ(sequence.images.size(), 3U);
  EXPECT_EQ(sequence.timestamps_ns[2], 100'000'000);
  EXPECT_EQ(sequence.camera.fx, 50.0);
  EXPECT_NEAR(sequence.camera.baseline_m, 0.1, 1e-12);
  EXPECT_EQ(sequence.camera.right_shift_px, 0.0);
  const cv::Mat second = cv::imread(sequence.images[1].right.string(), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(second.type(), CV_8UC1);
  EXPECT_EQ(second.at<unsigned char>(3, 3), 20);
}

TEST_F(ImportStereoTest, TimesOfNamesAndFiles) {
  WriteImages({"1403636579763555584.png", "1403636579813555456.png"});
  EXPECT_STREQ(Import().times, "names");
  EXPECT_EQ(OpenSequence({.folder = out()}).timestamps_ns[1], 1403636579813555456);
  fs::remove_all(out());
  request_.times = folder_.Write("times.txt", "0.5\n1.75\n");
  EXPECT_STREQ(Import().times, "file");
  EXPECT_EQ(OpenSequence({.folder = out()}).timestamps_ns[1], 1'750'000'000);
  fs::remove_all(out());
  request_.rate_hz = 20.0;
  ExpectError("--rate: found times in a file as well");
  request_.times.clear();
  ExpectError("--rate: found times in a name as well");
}

TEST_F(ImportStereoTest, WhatIsNotRectifiedWillBe) {
  WriteImages({"0.png"});
  request_.calibration = folder_.Write(
      "lens.yaml",
      "left: {fx: 50, fy: 50, cx: 32, cy: 24, lens: plumb_bob, coefficients: [-0.1, 0, 0, 0]}\n"
      "right: {fx: 51, fy: 50, cx: 32, cy: 24}\n"
      "right_from_left: [1, 0, 0, -0.1, 0, 1, 0, 0.001, 0, 0, 1, 0]\n");
  EXPECT_TRUE(Import().rectified);
  EXPECT_THAT(ReadFileBytes(out() / "import.json"), testing::HasSubstr("rectified_from_left"));
  EXPECT_NEAR(OpenSequence({.folder = out()}).camera.baseline_m, 0.1, 1e-4);
}

TEST_F(ImportStereoTest, TheCacheIsKeyedByContent) {
  WriteImages({"0.png"});
  int imports = 0;
  const auto import = [&] {
    return ImportIntoCache(request_, folder_.path() / "cache",
                           [&](std::size_t, std::size_t) { ++imports; });
  };
  const fs::path first = import();
  EXPECT_EQ(first.filename(), "kitchen");
  EXPECT_EQ(import(), first);
  EXPECT_EQ(imports, 1);
  WriteImages({"0.png"}, {64, 64});
  EXPECT_NE(import(), first);
}

// It was read as it was, or, without its record, stood in the way for ever.
TEST_F(ImportStereoTest, ADamagedEntryOfTheCacheIsMadeAgain) {
  WriteImages({"0.png", "1.png"});
  int imports = 0;
  const auto import = [&] {
    return ImportIntoCache(request_, folder_.path() / "cache",
                           [&](std::size_t done, std::size_t) { imports += done == 1 ? 1 : 0; });
  };
  const fs::path folder = import();
  const std::string other = ReadFileBytes(folder / "image_0/000001.png");
  for (const char* name :
       {"image_0/000000.png", "image_1/000000.png", "times.txt", "calib.txt", "import.json"}) {
    const std::string whole = ReadFileBytes(folder / name);
    std::string flipped = whole;
    flipped[whole.size() / 2] ^= 1;
    for (const std::string& bytes : {flipped, whole.substr(0, whole.size() / 2), other}) {
      imports = 0;
      WriteFileBytes(folder / name, bytes);
      EXPECT_EQ(import(), folder);
      EXPECT_EQ(imports, 1) << name;
      EXPECT_EQ(ReadFileBytes(folder / name), whole);
    }
    fs::remove(folder / name);
    EXPECT_EQ(import(), folder);
    EXPECT_EQ(ReadFileBytes(folder / name), whole);
  }
}

TEST_F(ImportStereoTest, BadInputLeavesNothing) {
  ExpectError("expected a folder of images or a video file");
  WriteImages({"0.png", "1.png"});
  fs::remove(request_.right / "1.png");
  ExpectError("found 1 images, expected 2, as many as in");
  folder_.Write("kitchen/right/1.png", "no image");
  ExpectError("1.png: found no image that can be decoded");
  cv::imwrite((request_.right / "1.png").string(), cv::Mat(40, 64, CV_8UC1, cv::Scalar(0)));
  ExpectError("image 1: found 64x40 px, expected 64x48 px");
  WriteImages({"0.png", "1.png"});
  request_.times = folder_.Write("times.txt", "1\n1\n");
  ExpectError("times.txt:2: found \"1\", expected a time after");
  request_.times = folder_.Write("times.txt", "1\n");
  ExpectError("found 1 times, expected 2");
  request_.times.clear();
  request_.calibration = folder_.Write(
      "cam.yaml",
      "fx: 50\nfy: 50\ncx: 32\ncy: 24\nbaseline_m: 0.1\nwidth_px: 640\nheight_px: 480\n");
  ExpectError("found a calibration of 640x480 px, expected 64x48 px");
}

}  // namespace
}  // namespace cvo
