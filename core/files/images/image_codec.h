// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>  // the flags
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// Image files. The kinds that runs and scenes consist of are read and written by libpng and
// libtiff, all others by OpenCV, whose library for them is loaded at the first call (see
// FindSymbol): a quarter of a second. The functions of that library itself are not linked. The
// results do not depend on who decodes or encodes.

// `flags` is one of cv::ImreadModes. Returns an empty image if the bytes cannot be decoded. May
// throw cv::Exception.
cv::Mat DecodeImage(std::string_view bytes, int flags);

// As above. Throws Error if the file cannot be read.
cv::Mat ReadImageFile(const std::filesystem::path& path, int flags);

// `extension` names the format, as in ".png"; `settings` are pairs of cv::ImwriteFlags and values.
// Throws Error if the image cannot be written in this format.
std::string EncodeImage(const char* extension, const cv::Mat& image,
                        const std::vector<int>& settings = {});

}  // namespace cvo
