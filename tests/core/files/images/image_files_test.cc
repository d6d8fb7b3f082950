// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <string>

#include "core/files/images/image_codec.h"
#include "core/files/images/shared_library.h"
#include "core/files/images/video.h"
#include "tests/support/error_message.h"
#include "tests/support/image_file.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

using testing::AllOf;
using testing::HasSubstr;

cv::Mat Gradient(int type) {
  cv::Mat image(32, 48, type);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) image.row(v).col(u) = cv::Scalar::all(5 * u + v);
  }
  return image;
}

TEST(ImageCodec, LosslessFormatsGiveBackTheImage) {
  const test::TempFolder folder;
  for (const int type : {CV_8UC1, CV_8UC3, CV_16UC1}) {
    const cv::Mat image = Gradient(type);
    test::WriteImageFile(folder.path() / "a.png", image);
    const cv::Mat read = ReadImageFile(folder.path() / "a.png", cv::IMREAD_UNCHANGED);
    ASSERT_EQ(read.type(), type);
    EXPECT_EQ(cv::norm(read, image, cv::NORM_INF), 0.0);
  }
}

TEST(ImageCodec, BytesThatAreNoImageGiveAnEmptyOne) {
  EXPECT_TRUE(DecodeImage("", cv::IMREAD_COLOR).empty());
  EXPECT_TRUE(DecodeImage("no image", cv::IMREAD_COLOR).empty());
  EXPECT_THAT(ErrorMessage([] { ReadImageFile("/no/such.png", cv::IMREAD_COLOR); }),
              HasSubstr("/no/such.png"));
}

TEST(Video, HasTheFramesThatWereWritten) {
  const test::TempFolder folder;
  const std::string file = (folder.path() / "a.avi").string();
  VideoWriter writer(file, cv::CAP_OPENCV_MJPEG, {'M', 'J', 'P', 'G'}, 10.0, {48, 32});
  ASSERT_TRUE(writer.ok());
  for (int i = 0; i < 3; ++i) writer.Add(Gradient(CV_8UC3));
  writer.Close();
  VideoReader reader(file);
  ASSERT_TRUE(reader.ok());
  EXPECT_EQ(reader.Get(cv::CAP_PROP_FRAME_COUNT), 3.0);
  for (int i = 0; i < 3; ++i) {
    const cv::Mat frame = reader.Next();
    ASSERT_EQ(frame.size(), cv::Size(48, 32));
    EXPECT_LT(cv::norm(frame, Gradient(CV_8UC3), cv::NORM_L1) / (3 * 48 * 32), 4.0);
  }
  EXPECT_TRUE(reader.Next().empty());
}

TEST(SharedLibrary, WhatIsMissingIsNamed) {
  EXPECT_THAT(ErrorMessage([] { FindSymbol("libnone.so.7", "f"); }), HasSubstr("libnone.so.7"));
  EXPECT_THAT(ErrorMessage([] { FindSymbol("libm.so.6", "no_such_function"); }),
              AllOf(HasSubstr("libm.so.6"), HasSubstr("no_such_function")));
  const auto cosine = FindFunction<double(double)>("libm.so.6", "cos");
  EXPECT_EQ(cosine(0.0), 1.0);
}

}  // namespace
}  // namespace cvo
