// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

// The image files of both cameras of a pair, in frame order, and their common size.
struct StereoImages {
  std::vector<StereoPaths> paths;
  int first = 0;  // number of the first file: a part of a recording starts later
  int width_px = 0;
  int height_px = 0;
};

// Lists the numbered images of both folders and checks that both have the same numbers without
// gaps, and that all have the same size. Throws Error otherwise.
StereoImages ListStereoImages(const std::filesystem::path& left_folder,
                              const std::filesystem::path& right_folder);

// Checks from the headers that the images exist, have 8 bits per channel and are all of the same
// size. Throws Error otherwise.
StereoImages CheckedImages(std::vector<StereoPaths> paths);

// The images of two cameras that were taken together: the nearest in time, within a quarter of a
// frame. Throws Error naming `right` unless most images of the camera that has fewer have a
// partner. Adds how many are left out to `notes`.
std::vector<std::pair<std::size_t, std::size_t>> PairByTime(const Times& left_ns,
                                                            const Times& right_ns,
                                                            const std::filesystem::path& right,
                                                            std::vector<std::string>& notes);

// Returns the files <number><extension> of a folder by number, with the extension in any case;
// others are ignored. Throws Error if there are none, or two with one number.
std::map<std::int64_t, std::filesystem::path> NumberedFiles(const std::filesystem::path& folder,
                                                            const std::string& extension);

// Decodes an image to 8-bit grey. Colour is converted here (0.299 R + 0.587 G + 0.114 B) and not by
// libraries, whose arithmetic depends on their version; 16 bits are scaled, transparency is
// ignored. Returns an empty image if the bytes cannot be decoded.
cv::Mat DecodeGrey(std::string_view bytes);

struct LoadedImage {
  cv::Mat grey;         // CV_8UC1; empty if there is a problem
  std::string sha256;   // of the file's bytes; empty if they cannot be read
  std::string problem;  // "<path>: found ..., expected ..."; empty if there is none

  bool ok() const { return problem.empty(); }
};

// Reads, hashes and decodes a PNG or JPEG file (DecodeGrey). A missing, damaged or truncated file
// is reported as the result's `problem`, so that the caller can skip the frame.
[[nodiscard]] LoadedImage LoadGrey(const std::filesystem::path& path);

// Loads the left (0) or right (1) image of a frame, and rectifies it if the files of the sequence
// are not rectified. An image whose size differs from the camera's is reported as a problem too.
[[nodiscard]] LoadedImage LoadFrameImage(const Sequence& sequence, std::size_t index, int side);

}  // namespace cvo
