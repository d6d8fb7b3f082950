// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/odometry/visual_odometry.h"

namespace cvo {

// Instantiated once per variant, in the variant's own .cc.
template <typename Variant>
std::unique_ptr<Odometry> MakeVariant(const OdometrySetup& setup, TaskPool& pool) {
  return std::make_unique<VisualOdometry<Variant>>(setup, pool);
}

}  // namespace cvo
