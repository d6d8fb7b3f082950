// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>

#include "experiments/datasets/sequence.h"

namespace cvo {

struct LoadedImage {
  cv::Mat grey;         // CV_8UC1; empty if there is a problem
  std::string sha256;   // of the file's bytes; empty if they cannot be read
  std::string problem;  // "<path>: found ..., expected ..."; empty if there is none

  bool ok() const { return problem.empty(); }
};

// Reads, hashes and decodes a PNG or JPEG file; colour is converted to grey (0.299 R + 0.587 G +
// 0.114 B). A missing, damaged or truncated file is reported as the result's `problem`, so that the
// caller can skip the frame.
[[nodiscard]] LoadedImage LoadGrey(const std::filesystem::path& path);

// Loads the left (0) or right (1) image of a frame, and rectifies it if the files of the sequence
// are not rectified. An image whose size differs from the camera's is reported as a problem too.
[[nodiscard]] LoadedImage LoadFrameImage(const Sequence& sequence, std::size_t index, int side);

}  // namespace cvo
