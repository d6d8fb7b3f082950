// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/import/import_stereo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/import/stereo_source.h"
#include "experiments/datasets/plausibility.h"
#include "experiments/datasets/sequence.h"
#include "tests/support/error_message.h"
#include "tests/support/image_file.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

class ImportStereoTest : public testing::Test {
 protected:
  ImportStereoTest() {
    request_.left = folder_.path() / "kitchen" / "left";
    request_.right = folder_.path() / "kitchen" / "right";
    request_.calibration = {
        folder_.Write("cam.yaml", "fx: 50\nfy: 50\ncx: 32\ncy: 24\nbaseline_m: 0.1\n")};
  }
  // Writes the images of both cameras, each of uniform grey: 10 for the first, 20 for the second,
  // and so on.
  void WriteImages(const std::vector<std::string>& names, const cv::Size& size = {64, 48}) const {
    for (const fs::path& side : {request_.left, request_.right}) {
      fs::create_directories(side);
      for (std::size_t i = 0; i < names.size(); ++i) {
        test::WriteImageFile(
            side / names[i],
            cv::Mat(size, CV_8UC3, cv::Scalar::all(10.0 * static_cast<double>(i + 1))));
      }
    }
  }
  ImportOutcome Import() const {
    return ImportStereo(request_, out(), [](std::size_t, std::size_t) {});
  }
  void ExpectError(const std::string& text) const {
    EXPECT_THAT(ErrorMessage([&] { Import(); }), testing::HasSubstr(text));
    EXPECT_FALSE(fs::exists(out()));
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      EXPECT_EQ(entry.path().string().find(".tmp-"), std::string::npos);
    }
  }
  fs::path out() const { return folder_.path() / "out"; }

  test::TempFolder folder_;
  StereoImport request_;
};

// Files may have any format, and names are numbers of any length, sorted by value.
TEST_F(ImportStereoTest, WritesASequenceThatCanBeOpened) {
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
  const cv::Mat second = ReadImageFile(sequence.images[1].right, cv::IMREAD_UNCHANGED);
  EXPECT_EQ(second.type(), CV_8UC1);
  EXPECT_EQ(second.at<unsigned char>(3, 3), 20);
}

// Regression: names used to be sorted as text, 10 before 2.
TEST_F(ImportStereoTest, NumbersInNamesAreSortedAsNumbers) {
  const std::vector<std::string> names = {"frame_l_0.png", "frame_l_2.png", "frame_l_10.png"};
  WriteImages(names);
  Import();
  const Sequence sequence = OpenSequence({.folder = out()});
  for (std::size_t i = 0; i < names.size(); ++i) {
    const cv::Mat image = ReadImageFile(sequence.images[i].left, cv::IMREAD_UNCHANGED);
    EXPECT_EQ(image.at<unsigned char>(3, 3), 10 * (i + 1)) << names[i];
  }
  const Json record = ReadJson(out() / "import.json");
  EXPECT_EQ(record.at("left_images"), Json(names));
  EXPECT_EQ(record.at("right_images"), Json(names));
}

// Each list is in the expected order and is sorted from its reverse.
TEST(ImageNames, AreSortedByTime) {
  const std::vector<std::vector<fs::path>> lists = {
      {"9.jpg", "10.png", "011.bmp"},
      {"-1.png", "0.png", "1.png"},
      {"1.25.png", "1.5.png", "2.0.png"},  // seconds
      {"0.1.png", "0.2.png", "0.10.png"},  // camera 0
      {"1403636579763555584.png", "1403636579813555456.png"},
      {"a_1_b_9.png", "a_1_b_10.png", "a_2_b_1.png"},
      {"x99999999999999999999.png", "x100000000000000000000.png"},
      {"a.png", "a1.png", "b.png"}};
  for (const std::vector<fs::path>& ordered : lists) {
    std::vector<fs::path> files(ordered.rbegin(), ordered.rend());
    SortByNumber(files);
    EXPECT_EQ(files, ordered);
  }
}

// Regression: an image without a partner used to be paired with the next image of the other camera.
TEST(ImageNames, ReportsAnImageWithoutAPartner) {
  const std::vector<fs::path> left = {"left/l_1.png", "left/l_2.png", "left/l_4.png"};
  const auto problem = [&](const std::vector<fs::path>& a, const std::vector<fs::path>& b) {
    return ErrorMessage([&] { CheckPartners(a, b); });
  };
  EXPECT_THAT(problem(left, {"right/r_01.png", "right/r_03.png", "right/r_04.png"}),
              testing::StartsWith("left/l_2.png: found no image 2 in right, expected "));
  EXPECT_THAT(problem({left[0], left[1]}, {"right/r_1.png", "right/r_2.png", "right/r_3.png"}),
              testing::StartsWith("right/r_3.png: found no image 3 in left, expected "));
  EXPECT_THAT(problem({"left/0.png", "left/1.png"}, {"right/1.png", "right/2.png"}),
              testing::StartsWith("left/0.png: found no image 0 in right, expected "));
}

TEST(ImageNames, WithoutCommonNumbersArePairedByPosition) {
  CheckPartners({"a/1.png", "a/2.png"}, {"b/0001.png", "b/0002.png"});
  CheckPartners({"a/a.png", "a/b.png"}, {"b/c.png", "b/d.png"});
  CheckPartners({"a/1_left0.png", "a/2_left0.png"}, {"b/1_right1.png", "b/3_right1.png"});
  CheckPartners({"a/left_0.png"}, {"b/right_1.png"});
}

// Regression: damaged pixels used to make the import refuse the whole sequence.
TEST_F(ImportStereoTest, DamagedPixelsLoseOnlyTheirFrame) {
  WriteImages({"0.png", "1.jpg", "2.png"});
  for (const char* name : {"0.png", "1.jpg"}) {
    const std::string whole = ReadFileBytes(request_.right / name);
    WriteFileBytes(request_.right / name, whole.substr(0, whole.size() - 20));
  }
  const ImportOutcome outcome = Import();
  ASSERT_EQ(outcome.damaged.size(), 2U);
  EXPECT_THAT(outcome.damaged[0], testing::StartsWith("frame 0: " + request_.right.string()));
  EXPECT_THAT(outcome.damaged[1], testing::HasSubstr("1.jpg: found a file cut short"));
  const Sequence sequence = OpenSequence({.folder = out()});
  EXPECT_TRUE(LoadFrameImage(sequence, 0, 0).ok());
  EXPECT_FALSE(LoadFrameImage(sequence, 0, 1).ok());
  EXPECT_FALSE(LoadFrameImage(sequence, 1, 1).ok());
  EXPECT_TRUE(LoadFrameImage(sequence, 2, 1).ok());
}

TEST_F(ImportStereoTest, ReadsTimesFromNamesAndFiles) {
  WriteImages({"1403636579763555584.png", "1403636579813555456.png"});
  EXPECT_STREQ(Import().times, "names");
  EXPECT_EQ(OpenSequence({.folder = out()}).timestamps_ns[1], 1403636579813555456);
  fs::remove_all(out());
  request_.times = folder_.Write("times.txt", "0.5\n0.75\n");
  EXPECT_STREQ(Import().times, "file");
  EXPECT_EQ(OpenSequence({.folder = out()}).timestamps_ns[1], 750'000'000);
  fs::remove_all(out());
  request_.rate_hz = 20.0;
  ExpectError("--rate: found times in a file as well");
  request_.times.clear();
  ExpectError("--rate: found times in a name as well");
}

TEST_F(ImportStereoTest, TimesOfALongerRecordingAreCut) {
  request_.times = folder_.Write("times.txt", "0\n0.1\n0.2\n0.3\n0.45\n");
  WriteImages({"0.png", "1.png", "3.png"});
  Import();
  const Sequence sequence = OpenSequence({.folder = out()});
  EXPECT_EQ(sequence.timestamps_ns[2], 300'000'000);
  EXPECT_THAT(FindImplausible(sequence),
              testing::Contains(testing::HasSubstr("5 times for 3 images: those of 0 to 3")));
  fs::remove_all(out());
  WriteImages({"03.png"});
  ExpectError("3.png: found the number of 03.png, expected another one");
  for (const fs::path& side : {request_.left, request_.right}) fs::remove_all(side);
  WriteImages({"2.png", "3.png"});
  ExpectError("found 5 times, expected 2, one per left image; more if these are numbered");
}

// Regression: such images used to be paired by their position. Of the left camera the last image
// has no partner, of the right one the third.
TEST_F(ImportStereoTest, PairsImagesByTheTimesInTheirNames) {
  const auto write = [&](const fs::path& side, const std::vector<std::string>& names) {
    fs::remove_all(side);
    for (const std::string& name : names) {
      fs::create_directories(side);
      test::WriteImageFile(side / (name + ".png"), cv::Mat(48, 64, CV_8UC1, cv::Scalar(9)));
    }
  };
  write(request_.left, {"1403636579.700000", "1403636579.750000", "1403636579.850000",
                        "1403636579.900000", "1403636579.950000"});
  write(request_.right, {"1403636579.700037", "1403636579.750037", "1403636579.800037",
                         "1403636579.850037", "1403636579.900037"});
  EXPECT_EQ(Import().frames, 4U);
  const Sequence sequence = OpenSequence({.folder = out()});
  EXPECT_EQ(sequence.timestamps_ns[2], 1403636579850000000);
  EXPECT_THAT(FindImplausible(sequence),
              testing::Contains(testing::HasSubstr("left out: 1 left, 1 right")));
  EXPECT_EQ(ReadJson(out() / "import.json").at("right_images")[2], "1403636579.850037.png");
  fs::remove_all(out());
  write(request_.right, {"1403636579.724", "1403636579.774", "1403636579.874", "1403636579.924"});
  ExpectError("right: found 0 of 4 images within 12.5 ms, a quarter of a frame, of a left image");
}

// Regression: times in ms or us were taken for seconds.
TEST_F(ImportStereoTest, InfersTheUnitOfTimes) {
  WriteImages({"0.png", "1.png", "2.png"});
  struct Case {
    const char* times;
    const char* unit;  // empty: refused
  };
  for (const Case& c : {Case{"0.05\n0.10\n0.15\n", "s"},
                        {"50\n100\n150\n", "ms"},
                        {"1403636579050\n1403636579100\n1403636579150\n", "ms"},
                        {"50000\n100000\n150000\n", "us"},
                        {"#time [ns],name\n50000000,a\n100000000,b\n150000000,c\n", "ns"},
                        {"1e-5\n2e-5\n3e-5\n", ""},
                        {"5e9\n1e10\n15e9\n", ""}}) {
    request_.times = folder_.Write("times.txt", c.times);
    fs::remove_all(out());
    if (*c.unit == '\0') {
      ExpectError("expected times in s, ms, us or ns that make 1 to 1000 frames per second");
      continue;
    }
    Import();
    const Sequence sequence = OpenSequence({.folder = out()});
    EXPECT_EQ(sequence.timestamps_ns[2] - sequence.timestamps_ns[1], 50'000'000) << c.times;
    const bool is_told = *c.unit == 'm' || *c.unit == 'u';
    EXPECT_THAT(
        FindImplausible(sequence),
        testing::Contains(testing::HasSubstr(StrCat("taken for ", c.unit, ", which makes 20 Hz")))
            .Times(is_told ? 1 : 0))
        << c.times;
  }
}

TEST_F(ImportStereoTest, RectifiesUnrectifiedImages) {
  WriteImages({"0.png"});
  request_.calibration = {folder_.Write(
      "lens.yaml",
      "left: {fx: 50, fy: 50, cx: 32, cy: 24, lens: plumb_bob, coefficients: [-0.1, 0, 0, 0]}\n"
      "right: {fx: 51, fy: 50, cx: 32, cy: 24}\n"
      "right_from_left: [1, 0, 0, -0.1, 0, 1, 0, 0.001, 0, 0, 1, 0]\n")};
  EXPECT_TRUE(Import().rectified);
  EXPECT_THAT(ReadFileBytes(out() / "import.json"), testing::HasSubstr("rectified_from_left"));
  EXPECT_NEAR(OpenSequence({.folder = out()}).camera.baseline_m, 0.1, 1e-4);
}

TEST_F(ImportStereoTest, TheCacheIsKeyedByContent) {
  WriteImages({"0.png", "1.png"});
  int imports = 0;
  const auto import = [&] {
    return ImportIntoCache(request_, folder_.path() / "cache",
                           [&](std::size_t done, std::size_t) { imports += done == 1 ? 1 : 0; });
  };
  const fs::path folder = import();
  EXPECT_EQ(folder.filename(), "kitchen");
  EXPECT_EQ(import(), folder);
  EXPECT_EQ(imports, 1);
  WriteImages({"0.png", "1.png"}, {64, 64});
  EXPECT_NE(import(), folder);
}

TEST_F(ImportStereoTest, BadInputLeavesNothing) {
  ExpectError("expected a folder of images");
  WriteImages({"0.png", "1.png"});
  fs::remove(request_.right / "1.png");
  ExpectError("left/1.png: found no image 1 in ");
  fs::rename(request_.right / "0.png", request_.right / "zero.png");
  ExpectError("found 1 images, expected 2, as many as in");
  fs::rename(request_.right / "zero.png", request_.right / "0.png");
  folder_.Write("kitchen/right/1.png", "no image");
  ExpectError("1.png: found no image that can be decoded");
  test::WriteImageFile(request_.right / "1.png", cv::Mat(40, 64, CV_8UC1, cv::Scalar(0)));
  ExpectError("1.png: found 64x40 px, expected 64x48 px");
  WriteImages({"0.png", "1.png"});
  request_.times = folder_.Write("times.txt", "1\n1\n");
  ExpectError("times.txt: found times like \"1\" and \"1\", expected times in s, ms, us or ns");
  request_.times = folder_.Write("times.txt", "1\n");
  ExpectError("found 1 times, expected 2");
  request_.times.clear();
  request_.calibration = {folder_.Write(
      "cam.yaml",
      "fx: 50\nfy: 50\ncx: 32\ncy: 24\nbaseline_m: 0.1\nwidth_px: 640\nheight_px: 480\n")};
  ExpectError("found a calibration of 640x480 px, expected 64x48 px");
}

}  // namespace
}  // namespace cvo
