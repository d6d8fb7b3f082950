// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace cvo {

// Decides by the file extension. Data sets that come as JPEG are read as they are.
bool IsJpeg(const std::filesystem::path& path);

// Reads the width and height in px from the header of a PNG file with 8 bits per channel, or of a
// JPEG file that is named as one. Throws Error naming `path` for anything else.
cv::Size ReadImageSize(const std::filesystem::path& path);

// Describes what is wrong with the bytes of a JPEG file: no start or no end marker. Empty if the
// file is complete.
[[nodiscard]] std::optional<std::string> FindJpegDamage(std::string_view bytes);

}  // namespace cvo
