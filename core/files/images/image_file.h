// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// Decodes an image with OpenCV. `flags` is one of cv::ImreadModes. Returns an empty image if the
// bytes cannot be decoded; of a file that is cut short it may return half an image.
cv::Mat DecodeImage(std::string_view bytes, int flags);

// Does the same for a file. Throws Error if it cannot be read.
cv::Mat ReadImageFile(const std::filesystem::path& path, int flags);

// `extension` names the format, as in ".png"; `settings` are pairs of cv::ImwriteFlags and values.
// Throws Error if the image cannot be written in this format.
std::string EncodeImage(const char* extension, const cv::Mat& image,
                        const std::vector<int>& settings = {});

}  // namespace cvo
