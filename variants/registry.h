// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

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

}  // namespace cvo
