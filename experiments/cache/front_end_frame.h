// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/features/stereo_feature.h"

namespace cvo {

// An image of a pair that cannot be decoded.
struct SideProblem {
  int side = 0;        // 0 left, 1 right
  std::string reason;  // what was found and what was expected, without the path
};

// The output of the front end for the pixels of one stereo pair.
struct FrontEndFrame {
  std::vector<StereoFeature> features;
  std::vector<SideProblem> problems;  // if not empty, there are no features
};

// Encodes the frame with every number exact. DecodeFrame throws Error for any other bytes.
std::string EncodeFrame(const FrontEndFrame& frame);
FrontEndFrame DecodeFrame(std::string_view bytes);

}  // namespace cvo
