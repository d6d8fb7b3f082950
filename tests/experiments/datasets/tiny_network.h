// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/temp_folder.h"

namespace cvo::test {

// Writes a Darknet network with an input of 64 x 64 px and one cell of two classes, the second of
// which it always detects: one convolution without weights, whose biases are the output. The box is
// 32 x 16 px large, in the middle of the input, with a score of (1 + e^-4)^-2. Returns the path of
// the .cfg.
inline std::string WriteTinyNetwork(const TempFolder& folder) {
  std::vector<float> numbers = {0, 0, 0, 0, 4, -4, 4};  // x, y, w, h, object, classes
  numbers.resize(7 + 7 * 3, 0.0F);                      // 7 filters of 1 x 1 x 3
  // The header: version 0.1.0 in 12 bytes, then the number of training images in 4 bytes.
  std::string weights(20, '\0');
  weights[4] = 1;
  weights.resize(16);
  weights.append(reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size());
  folder.Write("tiny.weights", weights);
  return folder
      .Write("tiny.cfg",
             "[net]\nwidth=64\nheight=64\nchannels=3\n\n"
             "[maxpool]\nsize=64\nstride=64\n\n"
             "[convolutional]\nfilters=7\nsize=1\nstride=1\npad=0\nactivation=linear\n\n"
             "[yolo]\nmask=0\nanchors=32,16\nclasses=2\nnum=1\n")
      .string();
}

}  // namespace cvo::test
