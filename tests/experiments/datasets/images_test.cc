// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include "experiments/datasets/images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <libdeflate.h>

#include <opencv2/core.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/files/images/image_file.h"
#include "core/files/sha256.h"
#include "experiments/datasets/formats/image_format.h"
#include "tests/experiments/datasets/folders.h"

namespace cvo {

namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Sha256, MatchesKnownValues) {
  EXPECT_EQ(Sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(Sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, HashesPiecesLikeTheWhole) {
  Sha256 hash;
  for (const char* piece : {"a", "", "bc"}) hash.Add(piece);
  EXPECT_EQ(hash.Hex(), Sha256Hex("abc"));
  EXPECT_THROW(hash.Add("more"), Error);
}

class LoadGreyTest : public testing::Test {
 protected:
  LoadedImage Load(const std::string& bytes) { return LoadGrey(folder_.Write("image.png", bytes)); }

  // Expects the error of a file that could be read but is not a complete image.
  void ExpectProblem(const std::string& bytes, const std::string& found) {
    const LoadedImage image = Load(bytes);
    EXPECT_FALSE(image.ok());
    EXPECT_TRUE(image.grey.empty());
    EXPECT_EQ(image.sha256, Sha256Hex(bytes));
    EXPECT_THAT(image.problem, AllOf(HasSubstr("image.png: found "), HasSubstr(found),
                                     HasSubstr("expected a whole PNG image")));
  }

  test::TempFolder folder_;
};

TEST_F(LoadGreyTest, DecodesAndHashes) {
  const std::string bytes = GreyPng();
  const LoadedImage image = Load(bytes);
  ASSERT_TRUE(image.ok()) << image.problem;
  EXPECT_EQ(image.sha256, Sha256Hex(bytes));
  EXPECT_EQ(image.grey.type(), CV_8UC1);
  EXPECT_EQ(image.grey.size(), cv::Size(kTestWidth_px, kTestHeight_px));
  EXPECT_EQ(image.grey.at<unsigned char>(1, 2), (kTestWidth_px + 2) * 7);
}

TEST_F(LoadGreyTest, ColourBecomesLuma) {
  cv::Mat colour(4, 4, CV_8UC3, cv::Scalar(0, 0, 255));  // red; OpenCV stores BGR
  colour.at<cv::Vec3b>(0, 1) = {0, 255, 0};
  colour.at<cv::Vec3b>(0, 2) = {255, 0, 0};
  const LoadedImage image = Load(EncodePng(colour));
  ASSERT_TRUE(image.ok()) << image.problem;
  EXPECT_EQ(image.grey.type(), CV_8UC1);
  EXPECT_EQ(image.grey.at<unsigned char>(0, 0), 76);
  EXPECT_EQ(image.grey.at<unsigned char>(0, 1), 150);
  EXPECT_EQ(image.grey.at<unsigned char>(0, 2), 29);
  const LoadedImage with_alpha = Load(EncodePng(cv::Mat(4, 4, CV_8UC4, cv::Scalar(0, 0, 255, 9))));
  ASSERT_TRUE(with_alpha.ok()) << with_alpha.problem;
  EXPECT_EQ(with_alpha.grey.at<unsigned char>(3, 3), 76);
}

TEST_F(LoadGreyTest, SixteenBitsAreScaled) {
  cv::Mat deep(4, 4, CV_16UC1, cv::Scalar(65535));
  deep.at<std::uint16_t>(1, 2) = 257 * 100;
  for (const int channels : {1, 3}) {
    cv::Mat image = deep;
    if (channels == 3) cv::merge(std::vector<cv::Mat>(3, deep), image);
    const LoadedImage loaded = Load(EncodePng(image));
    ASSERT_TRUE(loaded.ok()) << loaded.problem;
    EXPECT_EQ(loaded.grey.type(), CV_8UC1);
    EXPECT_EQ(loaded.grey.at<unsigned char>(1, 2), 100);
    EXPECT_EQ(loaded.grey.at<unsigned char>(0, 0), 255);
  }
}

TEST_F(LoadGreyTest, DetectsDamageToEveryByte) {
  const std::string bytes = GreyPng();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    EXPECT_FALSE(Load(damaged).ok()) << "byte " << i;
  }
}

TEST_F(LoadGreyTest, ReportsTheError) {
  const std::string bytes = GreyPng();
  ExpectProblem("", "an empty file");
  ExpectProblem("not an image at all, whatever its name says", "a file that is not PNG");
  ExpectProblem("\xff\xd8\xff\xe0", "a JPEG image");
  ExpectProblem(bytes.substr(0, bytes.size() - 12), "without an end");
  const std::size_t data = bytes.find("IDAT");
  ExpectProblem(bytes.substr(0, data + 10), "a file cut short after");
  std::string damaged = bytes;
  damaged[data + 12] = static_cast<char>(damaged[data + 12] ^ 1);
  ExpectProblem(damaged, "a wrong CRC in chunk IDAT");
  // All chunks are valid, but the one that holds the image data is missing.
  std::string hollow = bytes;
  const std::size_t begin = data - 4, end = bytes.size() - 12;
  ExpectProblem(hollow.erase(begin, end - begin), "no image data");
}

TEST_F(LoadGreyTest, MissingFileIsAProblemNotAnError) {
  const LoadedImage image = LoadGrey(folder_.path() / "absent.png");
  EXPECT_FALSE(image.ok());
  EXPECT_EQ(image.sha256, "");
  EXPECT_THAT(image.problem, HasSubstr("absent.png: found no such file"));
  EXPECT_FALSE(LoadGrey(folder_.path()).ok());
}

std::string BigEndian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255U);
  return bytes;
}

std::string Chunk(const std::string& type, const std::string& content) {
  const std::string body = type + content;
  return BigEndian(static_cast<std::uint32_t>(content.size())) + body +
         BigEndian(libdeflate_crc32(0, body.data(), body.size()));
}

std::string Deflated(const std::string& bytes) {
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(6);
  std::string out(libdeflate_zlib_compress_bound(compressor, bytes.size()), '\0');
  out.resize(
      libdeflate_zlib_compress(compressor, bytes.data(), bytes.size(), out.data(), out.size()));
  libdeflate_free_compressor(compressor);
  return out;
}

// The fields of the header that determine how a file is decoded.
struct Kind {
  char bits = 8;
  char colour_type = 0;
  char interlace = 0;
};

// Returns a PNG file whose rows cycle through these filters and hold random filtered bytes.
std::string RandomPng(cv::Size size, const std::vector<int>& filters, Kind kind = {}) {
  std::mt19937 random(7);
  std::string rows;
  for (int y = 0; y < size.height; ++y) {
    rows += static_cast<char>(filters[static_cast<std::size_t>(y) % filters.size()]);
    for (int x = 0; x < size.width; ++x) rows += static_cast<char>(random());
  }
  const std::string header = BigEndian(static_cast<std::uint32_t>(size.width)) +
                             BigEndian(static_cast<std::uint32_t>(size.height)) +
                             std::string{kind.bits, kind.colour_type, 0, 0, kind.interlace};
  const std::string data = Deflated(rows);
  return "\x89PNG\r\n\x1a\n" + Chunk("IHDR", header) + Chunk("IDAT", data.substr(0, 50)) +
         Chunk("IDAT", data.substr(50)) + Chunk("IEND", "");
}

cv::Mat DecodeByOpenCv(const std::string& bytes) {
  return DecodeImage(bytes, cv::IMREAD_UNCHANGED);
}

TEST(DecodeGreyPng, MatchesOpenCvForEachFilter) {
  for (const std::vector<int>& filters :
       std::vector<std::vector<int>>{{0}, {1}, {2}, {3}, {4}, {4, 3, 2, 1, 0}}) {
    const std::string bytes = RandomPng({37, 23}, filters);
    ASSERT_FALSE(FindPngDamage(bytes));
    const cv::Mat expected = DecodeByOpenCv(bytes);
    const cv::Mat image = DecodeGreyPng(bytes);
    ASSERT_EQ(image.size(), expected.size());
    EXPECT_EQ(cv::norm(image, expected, cv::NORM_INF), 0.0) << "filter " << filters[0];
  }
}

TEST(DecodeGreyPng, LeavesOtherFormatsToOpenCv) {
  EXPECT_FALSE(DecodeGreyPng(RandomPng({8, 8}, {0})).empty());
  for (const Kind& kind : {Kind{16, 0, 0}, Kind{4, 0, 0}, Kind{8, 2, 0}, Kind{8, 0, 1}}) {
    EXPECT_TRUE(DecodeGreyPng(RandomPng({8, 8}, {0}, kind)).empty());
  }
  std::string transparent = RandomPng({8, 8}, {0});
  const std::size_t data = transparent.find("IDAT") - 4;
  transparent.insert(data, Chunk("tRNS", std::string(2, '\0')));
  EXPECT_TRUE(DecodeGreyPng(transparent).empty());
}

TEST(DecodeGreyPng, RefusesDataOfTheWrongSizeOrAnUnknownFilter) {
  EXPECT_TRUE(DecodeGreyPng(RandomPng({8, 8}, {5})).empty());
  std::string larger = RandomPng({8, 8}, {0});
  larger[19] = 9;  // the least significant byte of the width
  EXPECT_TRUE(DecodeGreyPng(larger).empty());
  std::string huge = RandomPng({8, 8}, {0});
  huge[18] = 0x7f;
  huge[22] = 0x7f;  // about 1 GB: refused before it is allocated
  EXPECT_TRUE(DecodeGreyPng(huge).empty());
}

}  // namespace

}  // namespace cvo
