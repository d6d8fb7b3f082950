// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "experiments/cli/output_file.h"
#include "variants/registry.h"

namespace cvo {

// Returns load(). If `name` is not a file, an Error thrown by load() is wrong usage: UsageError.
template <typename Load>
auto LoadNamed(const std::string& name, const Load& load) {
  try {
    return load();
  } catch (const Error& error) {
    std::error_code none;
    if (std::filesystem::exists(name, none)) throw;
    throw UsageError(error.what());
  }
}

// Like FindVariant, but throws UsageError with the nearest names if there is no such variant.
const VariantInfo& VariantNamed(const std::string& name);

// Throws UsageError if the folder does not exist. The message gives the command that renders it if
// it has the name of a scene or of a seed of a family, otherwise similar names.
void CheckSequenceFolder(const std::filesystem::path& folder);

// Throws Error unless `detections` is empty, a file, a detector level of the sequence's scene,
// "labels" (see AreFromLabels) or "none".
void CheckDetections(const std::string& detections, const std::filesystem::path& folder);

}  // namespace cvo
