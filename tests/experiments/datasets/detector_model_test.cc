// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/detector_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
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

TEST(NetworkOutput, LayoutFromSizes) {
  EXPECT_EQ(LayoutOf({40, 7}, kInput), OutputLayout::kDarknet);
  EXPECT_EQ(LayoutOf({1, 42, 7}, kInput), OutputLayout::kYolox);
  EXPECT_EQ(LayoutOf({1, 126, 7}, kInput), OutputLayout::kYolov5);
  EXPECT_EQ(LayoutOf({1, 6, 42}, kInput), OutputLayout::kYolov8);
  EXPECT_FALSE(LayoutOf({1, 1000}, {}) == OutputLayout::kYolox);
  EXPECT_FALSE(LayoutOf({1, 3, 32, 64}, kInput));
  EXPECT_FALSE(LayoutOf({1, 41, 7}, kInput));
}

TEST(NetworkOutput, Darknet) {
  cv::Mat output = Zeros({2, 7});
  const float row[7] = {0.5F, 0.25F, 0.25F, 0.5F, 0.9F, 0.1F, 0.8F};
  std::copy(row, row + 7, output.ptr<float>(1));
  const auto boxes = DecodeOutput(output, OutputLayout::kDarknet, kInput, 2, 0.3);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_EQ(boxes[0].category, 1);
  EXPECT_FLOAT_EQ(static_cast<float>(boxes[0].score), 0.8F);  // already includes the 0.9
  ExpectBox(boxes[0].box, {24, 0, 40, 16});
}

// Cell 9 is the second cell in the second row of the first level, cell 33 the second cell of the
// second level.
TEST(NetworkOutput, YoloxCells) {
  cv::Mat output = Zeros({1, 42, 6});
  for (const int cell : {9, 33}) {
    float* row = output.ptr<float>(0, cell);
    row[0] = 0.5F;
    row[1] = 0.25F;
    row[2] = static_cast<float>(std::log(2.0));
    row[4] = 0.5F;
    row[5] = 0.8F;
  }
  const auto boxes = DecodeOutput(output, OutputLayout::kYolox, kInput, 1, 0.3);
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_NEAR(boxes[0].score, 0.4, 1e-6);
  ExpectBox(boxes[0].box, {12 - 8, 10 - 4, 12 + 8, 10 + 4});
  ExpectBox(boxes[1].box, {24 - 16, 4 - 8, 24 + 16, 4 + 8});
}

TEST(NetworkOutput, Yolov5AndYolov8) {
  cv::Mat v5 = Zeros({1, 126, 6});
  cv::Mat v8 = Zeros({1, 5, 42});
  const float values[6] = {30, 20, 10, 4, 0.5F, 0.9F};
  for (int i = 0; i < 6; ++i) v5.ptr<float>(0, 100)[i] = values[i];
  for (int i = 0; i < 4; ++i) v8.ptr<float>(0, i)[40] = values[i];
  v8.ptr<float>(0, 4)[40] = 0.45F;
  for (const auto& boxes : {DecodeOutput(v5, OutputLayout::kYolov5, kInput, 1, 0.3),
                            DecodeOutput(v8, OutputLayout::kYolov8, kInput, 1, 0.3)}) {
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_NEAR(boxes[0].score, 0.45, 1e-6);
    ExpectBox(boxes[0].box, {25, 18, 35, 22});
  }
}

TEST(NetworkOutput, RefusesAnotherNumberOfClasses) {
  EXPECT_THROW(DecodeOutput(Zeros({4, 7}), OutputLayout::kDarknet, kInput, 3, 0.3), Error);
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
