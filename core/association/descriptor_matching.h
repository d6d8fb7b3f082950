// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/association/match.h"
#include "core/features/stereo_feature.h"

namespace cvo {

// Brute force over descriptors alone: mutually nearest pairs within max_hamming whose best distance
// is at most `ratio` of the second best; features of the left image alone are left out. For a frame
// about which no prediction can be trusted.
std::vector<Match> MatchDescriptors(std::span<const Descriptor> landmarks,
                                    std::span<const StereoFeature> features, int max_hamming,
                                    double ratio);

}  // namespace cvo
