// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <opencv2/videoio.hpp>
#include <string>

namespace cvo {

// Video files through OpenCV, whose library for them is loaded at the first call (see FindSymbol).
// isOpened() of what is returned tells whether the file could be opened. Only virtual members of it
// may be called: all others would have to be linked.
std::unique_ptr<cv::VideoCapture> OpenVideo(const std::string& file);

// `backend` is one of cv::VideoCaptureAPIs, `code` names the compression, as in "avc1". May throw
// cv::Exception.
std::unique_ptr<cv::VideoWriter> CreateVideo(const std::string& file, int backend,
                                             const std::array<char, 4>& code,
                                             double frames_per_second, cv::Size size);

}  // namespace cvo
