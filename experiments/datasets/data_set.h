// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/datasets/sequence.h"

namespace cvo {

inline constexpr const char* kKittiDataSet = "kitti";
inline constexpr const char* kOtherDataSet = "other";

// Sequence::dataset: the one that was named, else the one whose calibration the sequence has. Names
// of folders do not count. Throws Error for a name that is none.
std::string DataSetOf(const Sequence& sequence, const std::string& named);

}  // namespace cvo
