// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "tests/support/temp_folder.h"

namespace cvo::test {

inline constexpr int kTinyWidth_px = 256;
inline constexpr int kTinyHeight_px = 128;

// A textured wall seen by a stereo camera that moves to the right, in KITTI odometry layout: grey
// PNG images in image_0 and image_1, calib.txt, times.txt and poses.txt.
void WriteTinySequence(const std::filesystem::path& folder, int frames);

// Truncates a file to its first half.
void CutFile(const std::filesystem::path& file);

// Writes a Darknet network with an input of 64 x 64 px and one cell of two classes, the second of
// which it always detects: one convolution without weights, whose biases are the output. The box is
// 32 x 16 px large, in the middle of the input, with a score of (1 + e^-4)^-2. Returns the path of
// the .cfg.
std::string WriteTinyNetwork(const TempFolder& folder);

}  // namespace cvo::test
