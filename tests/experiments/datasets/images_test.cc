// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST_F(LoadGreyTest, DetectsEveryTruncation) {
  const std::string bytes = GreyPng();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(Load(bytes.substr(0, size)).ok()) << size << " of " << bytes.size();
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
  ExpectProblem(bytes.substr(0, data + 10), "chunk IDAT at byte");
  std::string damaged = bytes;
  damaged[data + 12] = static_cast<char>(damaged[data + 12] ^ 1);
  ExpectProblem(damaged, "a wrong CRC in chunk IDAT");
  // All chunks are valid, but the one that holds the image data is missing.
  std::string hollow = bytes;
  const std::size_t begin = data - 4, end = bytes.size() - 12;
  ExpectProblem(hollow.erase(begin, end - begin), "no image data");
}

TEST_F(LoadGreyTest, DetectsMissingRowsInAnIntactFile) {
  // The header of a taller image in front of the data of this one, with a valid CRC.
  const std::string tall = GreyPng(kTestWidth_px, 4 * kTestHeight_px);
  const std::string low = GreyPng();
  const std::size_t header = tall.find("IDAT") - 4;
  ASSERT_EQ(header, low.find("IDAT") - 4);
  const LoadedImage image = Load(tall.substr(0, header) + low.substr(header));
  EXPECT_FALSE(image.ok());
}

TEST_F(LoadGreyTest, MissingFileIsAProblemNotAnError) {
  const LoadedImage image = LoadGrey(folder_.path() / "absent.png");
  EXPECT_FALSE(image.ok());
  EXPECT_EQ(image.sha256, "");
  EXPECT_THAT(image.problem, HasSubstr("absent.png: found no such file"));
  EXPECT_FALSE(LoadGrey(folder_.path()).ok());
}

TEST(ReadImageSize, ReadsThatOfPngFiles) {
  const test::TempFolder folder;
  EXPECT_EQ(ReadImageSize(folder.Write("a.png", GreyPng(1242, 375))), cv::Size(1242, 375));
  const cv::Mat colour(3, 5, CV_8UC3, cv::Scalar(1, 2, 3));
  EXPECT_EQ(ReadImageSize(folder.Write("b.png", EncodePng(colour))), cv::Size(5, 3));
}

}  // namespace
}  // namespace cvo
