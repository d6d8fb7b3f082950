// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

// The images of both cameras of a pair, in order.
struct StereoImages {
  std::vector<StereoPaths> paths;
  int width_px = 0;
  int height_px = 0;
};

// What stands around the number in the names of files.
struct NumberedName {
  std::string prefix = {};
  std::string extension = ".png";
};

// Lists numbered images in both folders and checks that they are numbered 0, 1, ... without a gap,
// as many on either side, and of one size. Throws Error.
StereoImages ListStereoImages(const std::filesystem::path& left_folder,
                              const std::filesystem::path& right_folder,
                              const NumberedName& name = {});

// Checks, from their headers, that there are images, of 8 bits and of one size. Throws Error.
StereoImages CheckedImages(std::vector<StereoPaths> paths);

// The files <prefix><number><extension> of a folder in order of their numbers, which must be 0, 1,
// ... without a gap. Throws Error that lists what is missing.
std::vector<std::filesystem::path> ListNumberedFiles(const std::filesystem::path& folder,
                                                     const NumberedName& name);

}  // namespace cvo
