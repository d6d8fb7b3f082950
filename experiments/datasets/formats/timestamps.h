// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace cvo {

// Parses a time such as "2011-09-26 13:02:25.967790592", with exactly nine decimals, to ns since
// 1970 (the file does not state its time zone). Empty for text of any other form.
[[nodiscard]] std::optional<std::int64_t> ParseDateTimeNs(std::string_view text);

// Read one timestamp per line, strictly increasing. Throw Error with file and line.
std::vector<std::int64_t> ReadDateTimes(const std::filesystem::path& path);     // KITTI raw
std::vector<std::int64_t> ReadSecondsTimes(const std::filesystem::path& path);  // KITTI odometry

// Returns the times of frames 0, 1, ... at a constant rate, for data without timestamps. KITTI's
// rate is 10 Hz.
std::vector<std::int64_t> NominalTimes(std::size_t frames, double rate_hz = 10.0);

}  // namespace cvo
