// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/files/images/float_tiff.h"
#include "core/files/images/image_codec.h"
#include "core/files/images/png_codec.h"
#include "core/files/images/shared_library.h"
#include "core/files/images/video.h"
#include "tests/support/damaged_tiff.h"
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

// OpenCV's own functions, which the program does not call for these kinds.
TEST(ImageCodec, PngFilesHaveTheBytesOfOpenCv) {
  const std::vector<std::vector<int>> settings = {
      {},
      {cv::IMWRITE_PNG_COMPRESSION, 1},
      {cv::IMWRITE_PNG_COMPRESSION, 6},
      {cv::IMWRITE_PNG_STRATEGY, cv::IMWRITE_PNG_STRATEGY_HUFFMAN_ONLY},
      {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY, cv::IMWRITE_PNG_STRATEGY_RLE}};
  for (const int type : {CV_8UC1, CV_8UC3, CV_16UC1, CV_16UC3}) {
    cv::Mat noise = Gradient(type);
    cv::RNG(1).fill(noise.colRange(10, 30), cv::RNG::UNIFORM, 0, 60000);
    const cv::Mat part = noise.colRange(1, 40);  // rows with padding
    for (std::size_t i = 0; i < settings.size(); ++i) {
      std::vector<unsigned char> expected;
      ASSERT_TRUE(cv::imencode(".png", part, expected, settings[i]));
      const std::string found = EncodePng(part, settings[i]);
      EXPECT_EQ(found, std::string(expected.begin(), expected.end())) << type << ", " << i;
      const cv::Mat read = DecodePng(found);
      ASSERT_EQ(read.type(), type);
      EXPECT_EQ(cv::norm(read, part, cv::NORM_INF), 0.0) << type << ", " << i;
    }
  }
}

TEST(ImageCodec, WhatLibpngDoesNotReadOpenCvDoes) {
  const cv::Mat transparent = Gradient(CV_8UC4);
  EXPECT_EQ(EncodePng(transparent, {}), "");
  const std::string bytes = EncodeImage(".png", transparent);
  EXPECT_TRUE(DecodePng(bytes).empty());
  EXPECT_EQ(cv::norm(DecodeImage(bytes, cv::IMREAD_UNCHANGED), transparent, cv::NORM_INF), 0.0);
  const std::string two_levels =
      EncodeImage(".png", Gradient(CV_8UC1), {cv::IMWRITE_PNG_BILEVEL, 1});
  EXPECT_TRUE(DecodePng(two_levels).empty());
  EXPECT_FALSE(DecodeImage(two_levels, cv::IMREAD_UNCHANGED).empty());
  const cv::Mat colour = Gradient(CV_8UC3);
  EXPECT_EQ(DecodeImage(EncodeImage(".png", colour), cv::IMREAD_GRAYSCALE).type(), CV_8UC1);
}

TEST(ImageCodec, FloatTiff) {
  const cv::Mat depth = Gradient(CV_32FC1);
  const std::string bytes = EncodeImage(".tiff", depth);
  EXPECT_TRUE(DecodeFloatTiff(bytes).has_value());
  const cv::Mat read = DecodeImage(bytes, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(read.type(), CV_32FC1);
  EXPECT_EQ(cv::norm(read, depth, cv::NORM_INF), 0.0);
  EXPECT_FALSE(DecodeFloatTiff(EncodeImage(".tiff", Gradient(CV_16UC1))).has_value());
}

// A changed byte may change pixels, but must not crash or read outside of the file.
TEST(ImageCodec, DamagedFilesAreReadOrRefused) {
  const std::string png = EncodeImage(".png", Gradient(CV_16UC1));
  for (std::size_t i = 0; i < png.size(); ++i) {
    EXPECT_TRUE(DecodePng(png.substr(0, i)).empty());
    std::string damaged = png;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    DecodePng(damaged);
  }
  test::ExpectDamageIsReadOrRefused(EncodeImage(".tiff", Gradient(CV_32FC1)));
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
