// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/files/images/image_file.h"
#include "core/files/text_file.h"

namespace cvo::test {

// Writes an image in the format of its extension. Throws Error if it cannot.
inline void WriteImageFile(const std::filesystem::path& path, const cv::Mat& image) {
  WriteFileBytes(path, EncodeImage(path.extension().c_str(), image));
}

}  // namespace cvo::test
