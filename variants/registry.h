// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/interface/odometry.h"

namespace cvo {

struct VariantInfo {
  std::string_view name;
  std::string_view changes;  // what it changes, one line
  Options (*defaults)();     // the options it starts from
  std::unique_ptr<Odometry> (*make)(const OdometrySetup& setup, TaskPool& pool);
};

// Every variant in the program, in the order in which they are listed to users: those with a
// definition of their own, then those that the ladder makes (variants/ladder.h).
std::span<const VariantInfo> Variants();
std::span<const VariantInfo> NamedVariantInfos();

// Throws Error naming the first of these.
const VariantInfo& FindVariant(std::string_view name);

}  // namespace cvo
