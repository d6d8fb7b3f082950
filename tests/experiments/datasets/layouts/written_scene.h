// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo::test {

// A sequence to be written in the layout of a data set, as numbers and pixels.
struct WrittenScene {
  struct Body {
    std::string name;
    std::string category;
    Eigen::Vector3d size_m;
    std::vector<RigidTransform> world_from_object;
  };

  StereoCamera camera;
  std::vector<std::int64_t> times_ns;
  std::vector<RigidTransform> world_from_left;
  std::vector<Body> bodies;
  std::vector<std::array<cv::Mat, 2>> images;  // [frame][side], grey
  std::vector<cv::Mat> masks;                  // CV_16UC1

  std::size_t frames() const { return images.size(); }
};

// Three frames of noise, 48 x 32 px, with two bodies: for what is wrong in a layout.
WrittenScene SmallScene();

// A rendered scene in our own layout, and the same as numbers. `edit` may change the pixels of its
// files before either is read.
class OwnScene {
 public:
  explicit OwnScene(const std::filesystem::path& folder);

  const WrittenScene& written() const { return written_; }
  // With its boxes of the detector.
  Sequence Open() const;
  std::filesystem::path detections() const { return folder_ / "detections/good.txt"; }
  // Sends its images through JPEG, as a data set that comes so, and keeps what remains.
  void CompressImages();

 private:
  void Read();

  std::filesystem::path folder_;
  WrittenScene written_;
};

// The numbers of a transform: [R t] row by row, or x y z, then the quaternion.
std::string MatrixText(const RigidTransform& pose, const char* separator);
std::string NumbersText(const std::vector<double>& numbers, const char* separator);

void WriteImage(const std::filesystem::path& path, const cv::Mat& image);

// A file with its first `from` replaced, which must be there.
void ReplaceIn(const std::filesystem::path& file, const std::string& from, const std::string& to);
// A file without the row `row` (from 1), or with it a second time after itself.
void DropRow(const std::filesystem::path& file, std::size_t row);
void RepeatRow(const std::filesystem::path& file, std::size_t row);

// The same camera, times, pixels and truth of the camera, and bodies at the same places (frames of
// bodies may differ by one turn each) that are visible in the same frames.
void ExpectSameSequence(const Sequence& own, const Sequence& other);

// The same errors of a run of `full`, to 1e-9. `tells_pixels`: the layout tells which body a pixel
// shows, so that the own scene is scored by it too; `clustering`: and tells it of all pixels.
void ExpectSameErrors(const Sequence& own, const Sequence& other, bool tells_pixels,
                      bool clustering);

}  // namespace cvo::test
