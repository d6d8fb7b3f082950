// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cvo::synth {

// Returns the bytes of a grey 32-bit float TIFF file. The rows of `values` have no padding. It has
// its own files because libtiff's declarations clash with OpenCV's types.
std::string EncodeFloatTiff(const float* values, int width_px, int height_px);

}  // namespace cvo::synth
