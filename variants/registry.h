// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/interface/frame.h"

namespace cvo {

struct VariantInfo {
  std::string name;
  std::string changes;    // one line on what it changes
  Options (*defaults)();  // the options it starts from
  std::unique_ptr<Odometry> (*make)(const OdometrySetup& setup, TaskPool& pool);
};

// Returns every variant in the program, in the order in which they are listed to users: those with
// a definition of their own, then those that the ladder makes (ladder.h).
std::span<const VariantInfo> Variants();
std::span<const VariantInfo> NamedVariantInfos();

// Throws Error if there is no such variant; the message lists those of NamedVariantInfos.
const VariantInfo& FindVariant(std::string_view name);

// Number of source files, generated from instantiate.cc.in, in which variants are compiled in
// parallel. Variant `index` of AllVariants is in file number index % kInstantiations.
inline constexpr std::size_t kInstantiations = 2;

template <std::size_t kInstantiation>
std::unique_ptr<Odometry> Instantiate(std::size_t index, const OdometrySetup& setup,
                                      TaskPool& pool);

}  // namespace cvo
