// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace cvo {

// "2011-09-26 13:02:25.967790592" in ns since 1970 (the file does not say in which zone); exactly
// this shape and nine decimals, or empty.
[[nodiscard]] std::optional<std::int64_t> ParseDateTimeNs(std::string_view text);

// One timestamp per line, strictly increasing. Throws Error with file and line.
std::vector<std::int64_t> ReadDateTimes(const std::filesystem::path& path);     // KITTI raw
std::vector<std::int64_t> ReadSecondsTimes(const std::filesystem::path& path);  // KITTI odometry

// Frames 0, 1, ... at one rate, where nothing has timestamps; KITTI's is 10 Hz.
std::vector<std::int64_t> NominalTimes(std::size_t frames, double rate_hz = 10.0);

}  // namespace cvo
