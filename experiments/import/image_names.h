// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace cvo {

// Sorts the image files of one folder by time: by value if all names are distinct numbers (times in
// seconds or nanoseconds), otherwise by name, with runs of digits compared as numbers, so that
// frame_2 precedes frame_10.
void SortByNumber(std::vector<std::filesystem::path>& files);

// Throws Error naming the first image whose number no image of the other camera has. Nothing is
// checked, and images remain paired by position, if names have no number or share one, or if all
// names are numbers and the cameras have none in common, as with timestamps of unsynchronised
// cameras.
void CheckPartners(const std::vector<std::filesystem::path>& left,
                   const std::vector<std::filesystem::path>& right);

}  // namespace cvo
