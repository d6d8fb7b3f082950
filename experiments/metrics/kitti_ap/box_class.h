// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/datasets/sequence.h"

namespace cvo {

// Classes of KITTI, whatever the case of their letters.
bool IsOfClass(const ObjectBox& box, const std::string& category);

// Of a class so close that a detection of either may lie on the other at no cost: vans for cars,
// sitting persons for pedestrians (tracking files call them "Person").
bool IsNeighbour(const ObjectBox& box, const std::string& category);

// A region in which nothing was labelled.
bool IsDontCare(const ObjectBox& label);

}  // namespace cvo
