// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/images/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <string>

#include "tests/support/error_message.h"
#include "tests/support/image_file.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

using testing::HasSubstr;

cv::Mat Gradient(int type) {
  cv::Mat image(32, 48, type);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) image.row(v).col(u) = cv::Scalar::all(5 * u + v);
  }
  return image;
}

TEST(ImageFile, LosslessFormatsGiveBackTheImage) {
  const test::TempFolder folder;
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1}) {
    const cv::Mat image = Gradient(type);
    test::WriteImageFile(folder.path() / "a.png", image);
    const cv::Mat read = ReadImageFile(folder.path() / "a.png", cv::IMREAD_UNCHANGED);
    ASSERT_EQ(read.type(), type);
    EXPECT_EQ(cv::norm(read, image, cv::NORM_INF), 0.0);
  }
}

TEST(ImageFile, BytesThatAreNoImageGiveAnEmptyOne) {
  EXPECT_TRUE(DecodeImage("", cv::IMREAD_COLOR).empty());
  EXPECT_TRUE(DecodeImage("no image", cv::IMREAD_COLOR).empty());
  EXPECT_THAT(ErrorMessage([] { ReadImageFile("/no/such.png", cv::IMREAD_COLOR); }),
              HasSubstr("/no/such.png"));
  EXPECT_THAT(ErrorMessage([] { EncodeImage(".none", cv::Mat(4, 4, CV_8UC1)); }),
              HasSubstr("an image to write as .none"));
}

}  // namespace
}  // namespace cvo
