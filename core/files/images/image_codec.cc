// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/images/image_codec.h"

#include "core/base/error.h"
#include "core/files/images/float_tiff.h"
#include "core/files/images/png_codec.h"
#include "core/files/images/shared_library.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

using Decoder = cv::Mat(cv::InputArray, int);
using Encoder = decltype(cv::imencode);

// Returns an image of a common kind as it is stored, without OpenCV's library. Empty for other
// kinds and, if only grey is wanted, for colours.
cv::Mat DecodeCommon(std::string_view bytes, bool only_grey) {
  if (bytes.starts_with("\x89PNG")) return DecodePng(bytes, only_grey);
  if (!bytes.starts_with("II*") && !bytes.starts_with("MM")) return {};
  std::optional<FloatImage> image = DecodeFloatTiff(bytes);
  if (!image) return {};
  return cv::Mat(image->height_px, image->width_px, CV_32FC1, image->values.data()).clone();
}

}  // namespace

cv::Mat DecodeImage(std::string_view bytes, int flags) {
  if (bytes.empty()) return {};
  if (flags == cv::IMREAD_UNCHANGED || flags == cv::IMREAD_GRAYSCALE) {
    const bool only_grey = flags == cv::IMREAD_GRAYSCALE;
    cv::Mat image = DecodeCommon(bytes, only_grey);
    if (!image.empty() && (!only_grey || image.type() == CV_8UC1)) return image;
  }
  static const auto decode =
      FindFunction<Decoder>(CVO_IMAGE_CODECS, "_ZN2cv8imdecodeERKNS_11_InputArrayEi");
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
  return decode(buffer, flags);
}

cv::Mat ReadImageFile(const std::filesystem::path& path, int flags) {
  return DecodeImage(ReadFileBytes(path), flags);
}

std::string EncodeImage(const char* extension, const cv::Mat& image,
                        const std::vector<int>& settings) {
  if (std::string_view(extension) == ".png") {
    if (std::string png = EncodePng(image, settings); !png.empty()) return png;
  }
  static const auto encode = FindFunction<Encoder>(
      CVO_IMAGE_CODECS,
      "_ZN2cv8imencodeERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKNS_11_InputArrayE"
      "RSt6vectorIhSaIhEERKSB_IiSaIiEE");
  const auto fail = [&](const std::string& found) {
    ThrowError(StrCat("an image to write as ", extension), found, "one that OpenCV can write");
  };
  std::vector<unsigned char> bytes;
  try {
    if (!encode(extension, image, bytes, settings)) fail("one that it cannot write");
  } catch (const cv::Exception& error) {
    fail(error.err);
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace cvo
