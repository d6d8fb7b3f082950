// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/images/image_file.h"

#include <dlfcn.h>

#include "core/base/error.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

// A function of OpenCV's imgcodecs by its linker's name. With what it needs it is 120 libraries,
// which take 0.05 s to load: only a program that meets an image for it does.
template <typename Function>
Function* Codec(const char* name) {
  static const auto library = ::dlopen(CVO_IMGCODECS, RTLD_NOW | RTLD_LOCAL);
  void* const function = library == nullptr ? nullptr : ::dlsym(library, name);
  if (function == nullptr) ThrowError("OpenCV's images", ::dlerror(), CVO_IMGCODECS);
  return reinterpret_cast<Function*>(function);
}

}  // namespace

cv::Mat DecodeImage(std::string_view bytes, int flags) {
  if (bytes.empty()) return {};
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
  return Codec<cv::Mat(cv::InputArray, int)>("_ZN2cv8imdecodeERKNS_11_InputArrayEi")(buffer, flags);
}

cv::Mat ReadImageFile(const std::filesystem::path& path, int flags) {
  return DecodeImage(ReadFileBytes(path), flags);
}

std::string EncodeImage(const char* extension, const cv::Mat& image,
                        const std::vector<int>& settings) {
  using Encode = bool(const std::string&, cv::InputArray, std::vector<unsigned char>&,
                      const std::vector<int>&);
  const auto encode = Codec<Encode>(
      "_ZN2cv8imencodeERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKNS_11_InputArrayE"
      "RSt6vectorIhSaIhEERKSB_IiSaIiEE");
  std::vector<unsigned char> bytes;
  std::string found = "one that it cannot write";
  try {
    if (encode(extension, image, bytes, settings)) return {bytes.begin(), bytes.end()};
  } catch (const cv::Exception& error) {
    found = error.err;
  }
  ThrowError(StrCat("an image to write as ", extension), found, "one that OpenCV can write");
}

}  // namespace cvo
