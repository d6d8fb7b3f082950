// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/images/video.h"

#include <new>

#include "core/files/images/shared_library.h"

namespace cvo {
namespace {

// Calls a constructor of T, which is the function `symbol`.
template <typename T, typename... Arguments>
std::unique_ptr<T> Construct(const char* symbol, Arguments... arguments) {
  const auto construct = FindFunction<void(void*, Arguments...)>(CVO_VIDEO, symbol);
  void* const memory = ::operator new(sizeof(T));
  try {
    construct(memory, arguments...);
  } catch (...) {
    ::operator delete(memory);
    throw;
  }
  return std::unique_ptr<T>(static_cast<T*>(memory));
}

}  // namespace

std::unique_ptr<cv::VideoCapture> OpenVideo(const std::string& file) {
  return Construct<cv::VideoCapture, const std::string&, int>(
      "_ZN2cv12VideoCaptureC1ERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEi", file,
      cv::CAP_ANY);
}

std::unique_ptr<cv::VideoWriter> CreateVideo(const std::string& file, int backend,
                                             const std::array<char, 4>& code,
                                             double frames_per_second, cv::Size size) {
  const int packed = code[0] | code[1] << 8 | code[2] << 16 | code[3] << 24;
  return Construct<cv::VideoWriter, const std::string&, int, int, double, cv::Size, bool>(
      "_ZN2cv11VideoWriterC1ERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEiidNS_5Size_"
      "IiEEb",
      file, backend, packed, frames_per_second, size, true);
}

}  // namespace cvo
