// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
//
// libviso2 LEFT RIGHT CALIBRATION OUT: stereo odometry over two folders of images, with a
// KITTI calibration. Writes a KITTI pose per frame. Not part of our build: see README.md.
#include <viso_stereo.h>

#include <fstream>
#include <iostream>
#include <limits>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

namespace {

// P0: fx 0 cx 0 0 fy cy ..., P1: ... with -fx * baseline in the fourth place.
bool ReadCalibration(const std::string& file, VisualOdometryStereo::parameters& parameters) {
  std::ifstream in(file);
  double p[2][12];
  std::string key;
  for (auto& row : p) {
    in >> key;
    for (double& value : row) in >> value;
  }
  parameters.calib.f = p[0][0];
  parameters.calib.cu = p[0][2];
  parameters.calib.cv = p[0][6];
  parameters.base = -p[1][3] / p[1][0];
  return static_cast<bool>(in);
}

int Run(const std::vector<std::string>& arguments) {
  VisualOdometryStereo::parameters parameters;
  if (!ReadCalibration(arguments[2], parameters)) {
    std::cerr << arguments[2] << ": no P0 and P1\n";
    return 1;
  }
  VisualOdometryStereo odometry(parameters);
  Matrix camera_from_world = Matrix::eye(4);
  std::vector<std::string> left;
  std::vector<std::string> right;
  cv::glob(arguments[0], left);  // in the order of their names
  cv::glob(arguments[1], right);
  std::ofstream out(arguments[3]);
  out.precision(std::numeric_limits<double>::max_digits10);
  for (std::size_t i = 0; i < left.size(); ++i) {
    cv::Mat images[2] = {cv::imread(left[i], cv::IMREAD_GRAYSCALE),
                         cv::imread(right[i], cv::IMREAD_GRAYSCALE)};
    if (images[0].empty() || images[0].size() != images[1].size()) {
      std::cerr << left[i] << ": cannot be read, or not the size of its right image\n";
      return 1;
    }
    int32_t size[3] = {images[0].cols, images[0].rows, images[0].cols};
    // A frame that fails keeps the pose of the one before. The first has no motion yet.
    if (odometry.process(images[0].data, images[1].data, size)) {
      camera_from_world = odometry.getMotion() * camera_from_world;
    } else if (i > 0) {
      std::cout << "frame " << i << ": no motion\n";
    }
    const Matrix world_from_camera = Matrix::inv(camera_from_world);
    for (int k = 0; k < 12; ++k) {
      out << world_from_camera.val[k / 4][k % 4] << (k < 11 ? ' ' : '\n');
    }
  }
  return out.flush() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 5) return Run({argv + 1, argv + argc});
  std::cerr << "usage: libviso2 LEFT RIGHT CALIBRATION OUT\n";
  return 2;
}
