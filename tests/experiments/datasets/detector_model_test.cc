// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/detector_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/files/json/json_record.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/error_message.h"

namespace cvo::detector_model_test {
namespace {

class DetectorModelTest : public testing::Test {
 protected:
  DetectorFiles Files() const {
    DetectorFiles files;
    files.model = test::WriteTinyNetwork(folder_);
    files.names = folder_.Write("two.names", "person\ncar\n");
    return files;
  }
  static void ExpectError(const DetectorFiles& files, const std::string& text) {
    EXPECT_THAT(ErrorMessage([&] { DetectorModel model(files); }), testing::HasSubstr(text));
  }

  test::TempFolder folder_;
};

// An image of 128 x 64 px is scaled by half and centred in the input.
TEST_F(DetectorModelTest, BoxesAreInPixelsOfTheImage) {
  DetectorModel model(Files());
  EXPECT_EQ(model.layout(), OutputLayout::kDarknet);
  EXPECT_EQ(model.input(), cv::Size(64, 64));
  const auto found = model.Detect(cv::Mat(64, 128, CV_8UC1, cv::Scalar(90)), {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].category, "Car");
  EXPECT_NEAR(found[0].score, std::pow(1.0 + std::exp(-4.0), -2.0), 1e-5);
  EXPECT_NEAR(found[0].box.left_px, 32.0, 1e-3);
  EXPECT_NEAR(found[0].box.top_px, 16.0, 1e-3);
  EXPECT_NEAR(found[0].box.right_px, 96.0, 1e-3);
  EXPECT_NEAR(found[0].box.bottom_px, 48.0, 1e-3);
  EXPECT_TRUE(model.Detect(cv::Mat(64, 128, CV_8UC3), {0.99, 0.5}).empty());
}

TEST_F(DetectorModelTest, BadFiles) {
  DetectorFiles files = Files();
  files.names = folder_.Write("three.names", "person\ncar\ndog\n");
  ExpectError(files, "found 2 classes, expected 3, as many as names");
  files.names = folder_.Write("none.names", "");
  ExpectError(files, "none.names: found no line");
  files = Files();
  files.weights = folder_.path() / "other.weights";
  ExpectError(files, "other.weights");
  files.weights = folder_.Write("short.weights", "half");
  ExpectError(files, "short.weights");
  files = Files();
  files.model = folder_.Write("model.onnx", "no network");
  ExpectError(files, "model.onnx");
  files.model = folder_.Write("model.pt", "");
  ExpectError(files, "expected a model .cfg (Darknet) or .onnx");
  files = Files();
  files.model = folder_.Write("plain.cfg",
                              "[net]\nwidth=64\nheight=64\nchannels=3\n\n[maxpool]\nsize=64\n"
                              "stride=64\n\n[convolutional]\nfilters=7\nsize=1\nstride=1\n"
                              "pad=0\nactivation=linear\n");
  files.weights = folder_.path() / "tiny.weights";
  ExpectError(files, "plain.cfg: found an output of 1 x 7 x 1 x 1");
}

TEST(KittiClass, MapsCocoNames) {
  EXPECT_EQ(KittiClass("car"), "Car");
  EXPECT_EQ(KittiClass("person"), "Pedestrian");
  EXPECT_EQ(KittiClass("traffic light"), "traffic light");
}

const cv::Size kInput(64, 32);  // 32 + 8 + 2 cells

cv::Mat Zeros(const std::vector<int>& sizes) {
  return cv::Mat(static_cast<int>(sizes.size()), sizes.data(), CV_32F, cv::Scalar(0));
}

void ExpectBox(const ImageBox& box, const ImageBox& expected) {
  EXPECT_NEAR(box.left_px, expected.left_px, 1e-4);
  EXPECT_NEAR(box.top_px, expected.top_px, 1e-4);
  EXPECT_NEAR(box.right_px, expected.right_px, 1e-4);
  EXPECT_NEAR(box.bottom_px, expected.bottom_px, 1e-4);
}

// One known box, in every layout, of the second of three classes: 30 to 50 and 25 to 35 px.
TEST(NetworkOutput, OneBoxThroughEachLayout) {
  constexpr float kScore = 0.9F;
  const std::vector<float> centred = {40, 30, 20, 10};
  const float cell = 8.0F;  // the 5th in the 3rd row of the first level: 5 + 3 * 8 = 29
  struct Case {
    OutputLayout layout;
    std::vector<float> row;
    std::vector<int> sizes;
    int at = 29;
  };
  const auto with = [&](std::vector<float> row, std::vector<float> more) {
    row.insert(row.end(), more.begin(), more.end());
    return row;
  };
  const std::vector<float> raw = {40 / cell - 5, 30 / cell - 3, std::log(20 / cell),
                                  std::log(10 / cell)};
  const std::vector<float> fractions = {40 / 64.0F, 30 / 32.0F, 20 / 64.0F, 10 / 32.0F};
  for (const Case& c : {
           Case{OutputLayout::kYolox, with(raw, {1, 0, kScore, 0}), {1, 42, 8}},
           Case{OutputLayout::kYoloxDecoded, with(centred, {1, 0, kScore, 0}), {1, 42, 8}},
           Case{OutputLayout::kYoloxDecoded, with(centred, {1, 0, kScore, 0}), {1, 8, 42}},
           Case{OutputLayout::kYolov5, with(centred, {1, 0, kScore, 0}), {1, 126, 8}},
           Case{OutputLayout::kYolov8, with(centred, {0, kScore, 0}), {1, 7, 42}},
           Case{OutputLayout::kYolov8, with(centred, {0, kScore, 0}), {1, 42, 7}},
           Case{OutputLayout::kYolov8, with(fractions, {0, kScore, 0}), {1, 7, 42}},
           Case{OutputLayout::kEndToEnd, {30, 25, 50, 35, kScore, 1}, {1, 300, 6}},
       }) {
    const auto boxes = static_cast<int>(c.row.size()) == c.sizes[2] ? c.sizes[1] : c.sizes[2];
    cv::Mat list(boxes, static_cast<int>(c.row.size()), CV_32F, cv::Scalar(0));
    std::copy(c.row.begin(), c.row.end(), list.ptr<float>(c.at));
    const cv::Mat plane = list.cols == c.sizes[2] ? list : cv::Mat(list.t());
    const cv::Mat output(3, c.sizes.data(), CV_32F, plane.data);
    const cv::Mat rows = RowsOf(output, 3, "net");
    ASSERT_EQ(LayoutOf(rows, kInput, 3), c.layout) << NameOf(c.layout);
    const auto found = DecodeRows(rows, c.layout, kInput, 3, 0.5);
    ASSERT_EQ(found.size(), 1U) << NameOf(c.layout);
    EXPECT_EQ(found[0].category, 1);
    EXPECT_NEAR(found[0].score, kScore, 1e-6);
    ExpectBox(found[0].box, {30, 25, 50, 35});
  }
}

TEST(NetworkOutput, OtherOutputsAreRefused) {
  const auto problem = [](const std::vector<int>& sizes, int categories) {
    return ErrorMessage([&] { RowsOf(Zeros(sizes), categories, "net"); });
  };
  EXPECT_THAT(problem({1, 42, 9}, 3), testing::HasSubstr("net: found an output of 1 x 42 x 9, "));
  EXPECT_THAT(problem({1, 39, 42}, 3), testing::HasSubstr("segmentation head"));
  EXPECT_THAT(problem({1, 32, 16, 16}, 3), testing::HasSubstr("masks or of heads"));
  const cv::Mat open = RowsOf(Zeros({1, 300, 6}), 2, "net");
  EXPECT_FALSE(LayoutOf(open, kInput, 2)) << "two classes, or end-to-end";
  EXPECT_FALSE(LayoutOf(RowsOf(Zeros({40, 7}), 3, "net"), kInput, 3)) << "neither 42 nor 126 rows";
  const auto decode = [](OutputLayout layout, std::vector<float> row) {
    const cv::Mat rows(1, static_cast<int>(row.size()), CV_32F, row.data());
    return ErrorMessage([&] { DecodeRows(rows, layout, kInput, 3, 0.5); });
  };
  EXPECT_THAT(decode(OutputLayout::kYolov8, {40, 30, 20, 10, 0.1F, -2.5F, 0.6F}),
              testing::HasSubstr("a score of -2.5, expected 0 to 1"));
  EXPECT_THAT(decode(OutputLayout::kEndToEnd, {30, 25, 50, 35, 2, 0.8F}),
              testing::HasSubstr("a score of 2"));
  EXPECT_THAT(decode(OutputLayout::kEndToEnd, {30, 25, 50, 35, 1, 0.8F}),
              testing::HasSubstr("found class 0.8"));
}

TEST(NetworkOutput, KeepsTheBestOfOverlappingBoxesOfAClass) {
  const ImageBox box = {0, 0, 10, 10};
  const ImageBox near = {1, 0, 11, 10};
  const auto kept = SuppressOverlaps(
      {{box, 0, 0.5}, {near, 0, 0.9}, {near, 1, 0.3}, {{20, 0, 30, 9}, 0, 0.1}}, 0.5);
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_EQ(kept[0].score, 0.9);
  EXPECT_EQ(kept[1].category, 1);
  EXPECT_EQ(kept[2].score, 0.1);
}

TEST(Letterbox, KeepsTheAspectRatioAndMapsBoxesBack) {
  cv::Mat input;
  const cv::Mat image(100, 400, CV_8UC3, cv::Scalar(10, 20, 30));
  const Letterbox box = FillInput(image, {200, 200}, Placement::kCentered, input);
  EXPECT_EQ(input.at<cv::Vec3b>(10, 100), cv::Vec3b(114, 114, 114));
  EXPECT_EQ(input.at<cv::Vec3b>(100, 100), cv::Vec3b(10, 20, 30));
  ExpectBox(box.ToImage({0, 75, 200, 125}), {0, 0, 400, 100});
  EXPECT_EQ(FillInput(image, {200, 200}, Placement::kTopLeft, input).offset_y_px, 0.0);
}

}  // namespace
}  // namespace cvo::detector_model_test
