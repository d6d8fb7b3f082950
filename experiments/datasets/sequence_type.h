// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

constexpr const char* kKittiOdometry = "kitti-odometry";

// Returns the type of the sequence in a folder, complete or not; "" if there is none.
std::string DetectSequenceType(const std::filesystem::path& folder);

// Whether the folder is a sequence with images of both cameras.
bool HasImages(const std::filesystem::path& folder);

// Does not throw: a folder that cannot be read counts as absent.
bool IsFolder(const std::filesystem::path& path);
// Whether both folders of a pair exist.
bool AreFolders(const std::filesystem::path& left, const std::filesystem::path& right);

// IsTrackingSet tells whether a folder contains several KITTI tracking sequences; TrackingSequences
// returns them as <folder>/<number>, sorted.
bool IsTrackingSet(const std::filesystem::path& folder);
std::vector<std::filesystem::path> TrackingSequences(const std::filesystem::path& set_folder);

// Removes ".", ".." and a trailing slash, so that the folder has a name and a parent.
std::filesystem::path NormalFolder(const std::filesystem::path& folder);

}  // namespace cvo
