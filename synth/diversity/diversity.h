// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace cvo::synth {

// Statistics of the bodies in rendered sequences. There is one value per body that is ever visible,
// except in `hidden_s`, which has one per interval in which a body is hidden, and in `moving_part`,
// which has one per frame.
struct Diversity {
  int scenes = 0;
  std::vector<double> speed_mps;     // mean over the frames, of moving bodies
  std::vector<double> size_px;       // median height of the visible box
  std::vector<double> visible_s;     // time with at least a tenth of the body visible
  std::vector<double> hidden_s;      // time within the image with less than a tenth visible
  std::vector<double> contrast;      // standard deviation of its grey levels, in one frame
  std::vector<double> disparity_px;  // median, of its centre
  std::vector<double> moving_part;   // fraction of left image pixels on moving bodies
};

// Adds the rendered sequence in `folder`. Throws Error if files or values are missing.
void AddSequence(const std::filesystem::path& folder, Diversity& diversity);

// Returns the quantile `part` (0 to 1) of unsorted values, with linear interpolation. Throws Error
// if there are no values.
double Quantile(std::vector<double> values, double part);

}  // namespace cvo::synth
