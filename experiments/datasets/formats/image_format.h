// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace cvo {

// Describes what is wrong with the bytes of a PNG file: a bad signature, a chunk that is truncated
// or has a wrong CRC, no image data, no end. Empty if the file is complete. Needed because decoders
// may return half an image.
[[nodiscard]] std::optional<std::string> FindPngDamage(std::string_view bytes);

// Decodes a PNG file of 8-bit grey without interlacing or transparency, as stereo pairs are, to
// CV_8UC1. Returns an empty image for anything else, including other kinds of PNG file, and if the
// pixels do not inflate to the image's size. Checksums are verified by FindPngDamage, not here.
// Takes half as long as OpenCV, whose decoding took a seventh of a run.
cv::Mat DecodeGreyPng(std::string_view bytes);

// Returns the extension with its dot, in lower case.
std::string LowerExtension(const std::filesystem::path& path);

// Decides by the file extension, in any case. Data sets that come as JPEG are read as they are.
bool IsJpeg(const std::filesystem::path& path);

// Reads the width and height in px from the header of a PNG file with 8 or 16 bits per channel, or
// of a JPEG file that is named as one. Throws Error naming `path` for anything else.
cv::Size ReadImageSize(const std::filesystem::path& path);

// Describes what is wrong with the bytes of a JPEG file: no start or no end marker. Empty if the
// file is complete.
[[nodiscard]] std::optional<std::string> FindJpegDamage(std::string_view bytes);

}  // namespace cvo
