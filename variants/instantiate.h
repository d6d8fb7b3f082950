// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#include "core/interface/frame.h"

namespace cvo {

// Number of source files, generated from instantiate.cc.in, in which variants are compiled in
// parallel. Variant `index` of AllVariants is in file number index % kInstantiations.
inline constexpr std::size_t kInstantiations = 4;

template <std::size_t kInstantiation>
std::unique_ptr<Odometry> Instantiate(std::size_t index, const OdometrySetup& setup,
                                      TaskPool& pool);

}  // namespace cvo
