// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace cvo::synth {

// How bodies of rendered sequences differ: one value for each body that is ever seen, but for
// `hidden_s`, which has one for each time that a body is hidden, and `moving_part`, of each frame.
struct Diversity {
  int scenes = 0;
  std::vector<double> speed_mps;     // mean over the frames, of bodies that move
  std::vector<double> size_px;       // median height of the visible box
  std::vector<double> visible_s;     // time with at least a tenth of it visible
  std::vector<double> hidden_s;      // within the image with less than a tenth of it visible
  std::vector<double> contrast;      // standard deviation of grey levels on it, in one frame
  std::vector<double> disparity_px;  // median, of its middle
  std::vector<double> moving_part;   // of the left image's pixels, those on bodies that move
};

// Reads the folder of a rendered sequence. Throws Error for what is missing in it.
void AddSequence(const std::filesystem::path& folder, Diversity& diversity);

// Of values in any order, linear between them; `part` from 0 to 1. Throws Error for none.
double Quantile(std::vector<double> values, double part);

}  // namespace cvo::synth
