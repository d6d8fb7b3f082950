// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/images/image_file.h"

#include "core/base/error.h"
#include "core/files/text_file.h"

namespace cvo {

cv::Mat DecodeImage(std::string_view bytes, int flags) {
  if (bytes.empty()) return {};
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
  return cv::imdecode(buffer, flags);
}

cv::Mat ReadImageFile(const std::filesystem::path& path, int flags) {
  return DecodeImage(ReadFileBytes(path), flags);
}

std::string EncodeImage(const char* extension, const cv::Mat& image,
                        const std::vector<int>& settings) {
  const auto fail = [&](const std::string& found) {
    ThrowError(StrCat("an image to write as ", extension), found, "one that OpenCV can write");
  };
  std::vector<unsigned char> bytes;
  try {
    if (!cv::imencode(extension, image, bytes, settings)) fail("one that it cannot write");
  } catch (const cv::Exception& error) {
    fail(error.err);
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace cvo
