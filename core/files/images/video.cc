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

// Only virtual members of the objects are called: others would have to be linked.

VideoReader::VideoReader(const std::string& file)
    : video_(Construct<cv::VideoCapture, const std::string&, int>(
          "_ZN2cv12VideoCaptureC1ERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEi", file,
          cv::CAP_ANY)) {}

VideoReader::~VideoReader() = default;

bool VideoReader::ok() const { return video_->isOpened(); }

double VideoReader::Get(int property) const { return video_->get(property); }

cv::Mat VideoReader::Next() {
  cv::Mat image;
  return video_->read(image) ? image : cv::Mat();
}

VideoWriter::VideoWriter(const std::string& file, int backend, const std::array<char, 4>& code,
                         double frames_per_second, cv::Size size)
    : video_(Construct<cv::VideoWriter, const std::string&, int, int, double, cv::Size, bool>(
          "_ZN2cv11VideoWriterC1ERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEiidNS_5"
          "Size_IiEEb",
          file, backend, code[0] | code[1] << 8 | code[2] << 16 | code[3] << 24, frames_per_second,
          size, true)) {}

VideoWriter::~VideoWriter() = default;

bool VideoWriter::ok() const { return video_->isOpened(); }

void VideoWriter::Add(const cv::Mat& image) { video_->write(image); }

void VideoWriter::Close() { video_->release(); }

}  // namespace cvo
