// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Usage: consumer SEQUENCE TUM. Runs the estimator on a sequence written by `clustervo synth
// render`, prints the clusters of the last frame and writes the camera trajectory to TUM.
#include <charconv>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "variants/stereo_odometry.h"

namespace fs = std::filesystem;

// The second line of calib.txt describes the right camera:
// "P1: fx 0 cx -fx*baseline  0 fy cy 0  0 0 1 0".
cvo::StereoCamera ReadCamera(const fs::path& file, const cv::Mat& image) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  std::string name;
  double p[12];
  in >> name;
  for (double& value : p) in >> value;
  return {.fx = p[0],
          .fy = p[5],
          .cx = p[2],
          .cy = p[6],
          .baseline_m = -p[3] / p[0],
          .width_px = image.cols,
          .height_px = image.rows};
}

// KITTI tracking rows: frame, track, class, three numbers, left, top, right, bottom, ..., score.
std::map<int, std::vector<cvo::Detection>> ReadBoxes(const fs::path& file) {
  std::map<int, std::vector<cvo::Detection>> boxes;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream row(line);
    cvo::Detection box;
    int frame;
    std::string skipped;
    row >> frame >> skipped >> box.category >> skipped >> skipped >> skipped >> box.box.left_px >>
        box.box.top_px >> box.box.right_px >> box.box.bottom_px;
    for (int i = 0; i < 7; ++i) row >> skipped;
    row >> box.score;
    boxes[frame].push_back(box);
  }
  return boxes;
}

// Returns the shortest text that parses back to the same number.
std::string Shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

void Run(const fs::path& folder, const fs::path& tum) {
  const auto read = [&](const char* side, int frame) {
    std::string name = std::to_string(frame);
    name.insert(0, 6 - name.size(), '0');
    return cv::imread((folder / side / (name + ".png")).string(), cv::IMREAD_GRAYSCALE);
  };
  auto boxes = ReadBoxes(folder / "detections" / "good.txt");
  cvo::StereoOdometry odometry(
      {.camera = ReadCamera(folder / "calib.txt", read("image_0", 0)), .threads = 2});

  std::vector<std::string> times;
  std::ifstream in(folder / "times.txt");
  for (std::string seconds; in >> seconds; times.push_back(seconds)) {
    const int i = static_cast<int>(times.size());
    const cvo::FrameReport frame = odometry.Process(
        read("image_0", i), read("image_1", i), std::llround(std::stod(seconds) * 1e9), boxes[i]);
    if (i != 5) continue;
    for (const cvo::ClusterReport& body : frame.clusters) {
      std::cout << body.category << " " << ToString(body.status) << "\n";
    }
  }

  std::ofstream out(tum);
  const std::vector<cvo::RigidTransform> trajectory = odometry.Trajectory();
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    out << times[i];
    for (int k : {4, 5, 6, 0, 1, 2, 3}) out << ' ' << Shortest(trajectory[i].data()[k]);
    out << '\n';
  }
}

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "usage: consumer SEQUENCE TUM\n";
    return 2;
  }
  Run(argv[1], argv[2]);
} catch (const std::exception& error) {
  std::cerr << "consumer: " << error.what() << '\n';
  return 1;
}
