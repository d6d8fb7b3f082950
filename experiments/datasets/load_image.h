// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>

#include "experiments/datasets/sequence.h"

namespace cvo {

struct LoadedImage {
  cv::Mat grey;         // CV_8UC1; empty where `problem` says why
  std::string sha256;   // of the file's bytes; empty where they cannot be read
  std::string problem;  // "<path>: found ..., expected ..."

  bool ok() const { return problem.empty(); }
};

// Reads, hashes and decodes one PNG (or JPEG) file; colour becomes grey (0.299 R + 0.587 G + 0.114
// B). A file that is missing, damaged or cut short is a problem in the result, for the frame to be
// skipped.
[[nodiscard]] LoadedImage LoadGrey(const std::filesystem::path& path);

// The left (0) or right (1) image of a frame, rectified where the sequence's files are not; of
// another size than the camera's it is a problem too.
[[nodiscard]] LoadedImage LoadFrameImage(const Sequence& sequence, std::size_t index, int side);

}  // namespace cvo
