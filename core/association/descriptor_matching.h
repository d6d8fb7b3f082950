// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/association/match.h"
#include "core/features/stereo_feature.h"

namespace cvo {

// Matches by descriptors alone, by brute force: mutually nearest pairs within max_hamming whose
// distance is less than `ratio` times the second best. Ignores left-only features. For frames for
// which no prediction can be trusted.
std::vector<Match> MatchDescriptors(std::span<const Descriptor> landmarks,
                                    std::span<const StereoFeature> features, int max_hamming,
                                    double ratio);

}  // namespace cvo
