// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/datasets/sequence.h"

namespace cvo {

// Whether the box is of this KITTI class, ignoring case.
bool IsOfClass(const ObjectBox& box, const std::string& category);

// Whether the box is of a class so similar to `category` that matching a detection to it is not
// penalised: vans for cars, sitting persons for pedestrians (tracking files call them "Person").
bool IsNeighbour(const ObjectBox& box, const std::string& category);

// Whether the label marks a region in which objects were not labelled.
bool IsDontCare(const ObjectBox& label);

}  // namespace cvo
