// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace cvo {

// Sorts the image files of one folder by time: by value if all names are distinct numbers (times in
// seconds or nanoseconds), otherwise by name, with runs of digits compared as numbers, so that
// frame_2 precedes frame_10.
void SortByNumber(std::vector<std::filesystem::path>& files);

// Throws Error naming the first image whose number no image of the other camera has. Nothing is
// checked, and images remain paired by position, if names have no number or share one, or if all
// names are numbers and the cameras have none in common.
void CheckPartners(const std::vector<std::filesystem::path>& left,
                   const std::vector<std::filesystem::path>& right);

struct SourceImage {
  cv::Mat grey;        // 8 bits; empty if damaged
  cv::Size size;       // from the header if damaged
  std::string damage;  // "<file>: found ..., expected ..."; empty if intact
};

// Returns the images in a folder (SortByNumber). Throws Error if there is none.
std::vector<std::filesystem::path> ListImages(const std::filesystem::path& folder);

// Throws Error if not even the header of the image can be read.
SourceImage ReadSourceImage(const std::filesystem::path& file);

// The images of both cameras as frames. If the names are times, images are paired by time
// (PairByTime); otherwise by number (CheckPartners), or by position.
struct StereoSource {
  std::array<std::vector<std::filesystem::path>, 2> files;
  std::vector<std::int64_t> times_ns = {};  // of the left images; empty if names tell none
  std::size_t listed = 0;                   // number of left images in the folder
  std::vector<double> numbers = {};         // in their names; 0, 1, ... if not all have their own
  std::vector<std::size_t> kept = {};       // which of them are in `files`
  std::vector<std::string> notes = {};      // the unit of the times, and what is left out
};
// Throws Error for images without a partner, and for times of no plausible rate.
StereoSource FindStereo(const std::filesystem::path& left, const std::filesystem::path& right);

}  // namespace cvo
