// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cvo::synth {

// A grey 32-bit float TIFF file's bytes from rows without padding. Apart from other headers: what
// libtiff declares clashes with OpenCV's types.
std::string EncodeFloatTiff(const float* values, int width_px, int height_px);

}  // namespace cvo::synth
