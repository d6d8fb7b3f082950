// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "experiments/cli/output_file.h"
#include "variants/registry.h"

namespace cvo {

// What `load` returns. Where `name` is no file, an Error of it is wrong usage: UsageError.
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

// As FindVariant; UsageError with the nearest names where there is none.
const VariantInfo& VariantNamed(const std::string& name);

// Throws UsageError for a folder that is not there: with the command that renders it, where it has
// the name of a scene or of a seed of a family, else with names near it.
void CheckSequenceFolder(const std::filesystem::path& folder);

// Throws Error for what is neither a file nor a level of the sequence's scene, "labels" or "none".
void CheckDetections(const std::string& detections, const std::filesystem::path& folder);

}  // namespace cvo
