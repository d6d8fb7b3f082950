// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

constexpr const char* kKittiRaw = "kitti-raw";
constexpr const char* kKittiOdometry = "kitti-odometry";
constexpr const char* kKittiTracking = "kitti-tracking";

// The type of the sequence that a folder is, complete or not; "" where it is none.
std::string DetectSequenceType(const std::filesystem::path& folder);

// A folder with several KITTI tracking sequences, and these as <folder>/<number>, sorted.
bool IsTrackingSet(const std::filesystem::path& folder);
std::vector<std::filesystem::path> TrackingSequences(const std::filesystem::path& set_folder);

// Without "." and "..", and without a slash at the end, so that it has a name and a parent.
std::filesystem::path NormalFolder(const std::filesystem::path& folder);

}  // namespace cvo
