// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <libdeflate.h>

#include <opencv2/core.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/files/images/image_file.h"
#include "experiments/datasets/formats/image_format.h"

namespace cvo {
namespace {

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
