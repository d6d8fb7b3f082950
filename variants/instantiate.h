// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#include "core/interface/odometry.h"

namespace cvo {

// Variants are compiled in so many source files, made of instantiate.cc.in, side by side; variant
// `index` of AllVariants in number index % kInstantiations.
inline constexpr std::size_t kInstantiations = 4;

template <std::size_t kInstantiation>
std::unique_ptr<Odometry> Instantiate(std::size_t index, const OdometrySetup& setup,
                                      TaskPool& pool);

}  // namespace cvo
