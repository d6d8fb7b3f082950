// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/experiments/runner/tiny_sequence.h"

#include <fstream>
#include <iomanip>
#include <opencv2/core.hpp>
#include <sstream>
#include <vector>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "tests/support/image_file.h"

namespace cvo::test {
namespace {

constexpr double kFocal_px = 200.0;
constexpr double kBaseline_m = 0.5;
constexpr int kDisparity_px = 10;  // of the wall
constexpr int kStep_px = 3;        // leftward motion of the wall per frame
constexpr int kBlock_px = 4;       // side of a block of one grey value

// A wall of blocks with random grey values, wide enough for all frames.
cv::Mat Wall(int frames) {
  cv::Mat wall(kTinyHeight_px, kTinyWidth_px + kStep_px * frames + kDisparity_px, CV_8UC1);
  Rng rng(1, "tiny wall");
  const int columns = wall.cols / kBlock_px + 1;
  std::vector<unsigned char> blocks(
      static_cast<std::size_t>(columns * (wall.rows / kBlock_px + 1)));
  for (unsigned char& block : blocks) block = static_cast<unsigned char>(rng.UniformInt(256));
  for (int v = 0; v < wall.rows; ++v) {
    for (int u = 0; u < wall.cols; ++u) {
      wall.at<unsigned char>(v, u) =
          blocks[static_cast<std::size_t>(v / kBlock_px * columns + u / kBlock_px)];
    }
  }
  return wall;
}

std::string ImageName(int frame) {
  std::ostringstream name;
  name << std::setw(6) << std::setfill('0') << frame << ".png";
  return name.str();
}

void WriteCalibration(const std::filesystem::path& file) {
  std::ofstream out(file);
  for (int camera = 0; camera < 2; ++camera) {
    out << "P" << camera << ": " << kFocal_px << " 0 128 " << -camera * kFocal_px * kBaseline_m
        << " 0 " << kFocal_px << " 64 0 0 0 1 0\n";
  }
}

}  // namespace

void WriteTinySequence(const std::filesystem::path& folder, int frames) {
  const cv::Mat wall = Wall(frames);
  std::filesystem::create_directories(folder / "image_0");
  std::filesystem::create_directories(folder / "image_1");
  WriteCalibration(folder / "calib.txt");
  std::ofstream times(folder / "times.txt");
  std::ofstream poses(folder / "poses.txt");
  const double depth_m = kFocal_px * kBaseline_m / kDisparity_px;
  for (int i = 0; i < frames; ++i) {
    const cv::Rect left(kStep_px * i, 0, kTinyWidth_px, kTinyHeight_px);
    const cv::Rect right = left + cv::Point(kDisparity_px, 0);
    WriteImageFile(folder / "image_0" / ImageName(i), wall(left));
    WriteImageFile(folder / "image_1" / ImageName(i), wall(right));
    times << 0.1 * i << '\n';
    poses << "1 0 0 " << i * kStep_px * depth_m / kFocal_px << " 0 1 0 0 0 0 1 0\n";
  }
}

void CutFile(const std::filesystem::path& file) {
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
}

std::string WriteTinyNetwork(const TempFolder& folder) {
  std::vector<float> numbers = {0, 0, 0, 0, 4, -4, 4};  // x, y, w, h, object, classes
  numbers.resize(7 + 7 * 3, 0.0F);                      // 7 filters of 1 x 1 x 3
  // The header: version 0.1.0 in 12 bytes, then the number of training images in 4 bytes.
  std::string weights(20, '\0');
  weights[4] = 1;
  weights.resize(16);
  weights.append(reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size());
  folder.Write("tiny.weights", weights);
  return folder
      .Write("tiny.cfg",
             "[net]\nwidth=64\nheight=64\nchannels=3\n\n"
             "[maxpool]\nsize=64\nstride=64\n\n"
             "[convolutional]\nfilters=7\nsize=1\nstride=1\npad=0\nactivation=linear\n\n"
             "[yolo]\nmask=0\nanchors=32,16\nclasses=2\nnum=1\n")
      .string();
}

}  // namespace cvo::test
