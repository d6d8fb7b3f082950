// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace cvo::test {

inline constexpr int kTinyWidth_px = 256;
inline constexpr int kTinyHeight_px = 128;

// A textured wall seen by a stereo camera that moves to the right, in KITTI odometry layout: grey
// PNG images in image_0 and image_1, calib.txt, times.txt and poses.txt.
void WriteTinySequence(const std::filesystem::path& folder, int frames);

// Truncates a file to its first half.
void CutFile(const std::filesystem::path& file);

}  // namespace cvo::test
