// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

constexpr const char* kKittiOdometry = "kitti-odometry";

// The type of the sequence that a folder is, complete or not; "" where it is none.
std::string DetectSequenceType(const std::filesystem::path& folder);

// Whether it is a sequence with images of both cameras.
bool HasImages(const std::filesystem::path& folder);

// Quiet where a folder cannot be read: then there is none.
bool IsFolder(const std::filesystem::path& path);
// Both sides of a pair.
bool AreFolders(const std::filesystem::path& left, const std::filesystem::path& right);

// A folder with several KITTI tracking sequences, and these as <folder>/<number>, sorted.
bool IsTrackingSet(const std::filesystem::path& folder);
std::vector<std::filesystem::path> TrackingSequences(const std::filesystem::path& set_folder);

// Without "." and "..", and without a slash at the end, so that it has a name and a parent.
std::filesystem::path NormalFolder(const std::filesystem::path& folder);

}  // namespace cvo
