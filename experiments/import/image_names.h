// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace cvo {

// The image files of one folder in order of time: by value if all names are different numbers
// (times in seconds or nanoseconds), else by name, with runs of digits compared as numbers, so that
// frame_2 precedes frame_10.
void SortByNumber(std::vector<std::filesystem::path>& files);

// Throws Error naming the first image whose number no image of the other camera has. Nothing is
// known, and images stay paired by position, if names have no number or share one, and if all names
// are numbers and both cameras have none in common: times of cameras that are not synchronised.
void CheckPartners(const std::vector<std::filesystem::path>& left,
                   const std::vector<std::filesystem::path>& right);

}  // namespace cvo
