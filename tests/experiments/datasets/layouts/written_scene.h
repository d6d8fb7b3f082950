// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo::test {

// The content of a sequence, as numbers and pixels, to be written in the layout of a data set.
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

// Returns three frames of noise, 48 x 32 px, with two bodies. For tests of malformed files.
WrittenScene SmallScene();

// A ray-cast scene in our own layout, together with its content as a WrittenScene.
class OwnScene {
 public:
  explicit OwnScene(const std::filesystem::path& folder);

  const WrittenScene& written() const { return written_; }
  // Opens the scene with the boxes of its detector.
  Sequence Open() const;
  std::filesystem::path detections() const { return folder_ / "detections/good.txt"; }

 private:
  void Read();

  std::filesystem::path folder_;
  WrittenScene written_;
};

// Formats a transform as the 16 numbers of its 4 x 4 matrix, row by row.
std::string MatrixText(const RigidTransform& pose, const char* separator);
std::string NumbersText(const std::vector<double>& numbers, const char* separator);

void WriteImage(const std::filesystem::path& path, const cv::Mat& image);

// Edits of a file: `from` becomes `to` where it is first (Error if it is nowhere), row `row`,
// counted from 1, is removed or stands twice, or the last `bytes` are missing.
using Edit = std::function<void(const std::filesystem::path& file)>;
Edit Replace(const std::string& from, const std::string& to);
Edit DropRow(std::size_t row);
Edit RepeatRow(std::size_t row);
Edit CutEnd(std::size_t bytes);

// Edits the file, opens the sequence, expects an error with each part of "<part> | <part>", and
// mends the file.
void ExpectRefused(const SequenceRequest& request, const std::filesystem::path& file,
                   const Edit& edit, const std::string& says);

// Expects the same camera, images, camera poses, and timestamps up to a constant offset, and bodies
// with the same poses and visibility in every frame. The object frame of a body may differ by a
// constant rotation.
void ExpectSameSequence(const Sequence& own, const Sequence& other);

// Expects the same errors, to 1e-9, of a run of `full` on each. `tells_pixels`: the layout knows
// which body a pixel shows; otherwise the own scene is scored without its masks, too. `clustering`:
// also compares the clustering scores, which need the body of every pixel.
void ExpectSameErrors(const Sequence& own, const Sequence& other, bool tells_pixels,
                      bool clustering);

}  // namespace cvo::test
