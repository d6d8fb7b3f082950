// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/yolo/detector_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/experiments/yolo/tiny_network.h"

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
    try {
      DetectorModel model(files);
      ADD_FAILURE() << "no error: " << text;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(text));
    }
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

}  // namespace
}  // namespace cvo::detector_model_test
