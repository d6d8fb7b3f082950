// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "variants/registry.h"

namespace cvo {

// As FindVariant, with the nearest names where there is none.
const VariantInfo& VariantNamed(const std::string& name);

// Throws Error for a folder that is not there: with the command that renders it, where it has the
// name of a scene or of a seed of a family, else with names near it.
void CheckSequenceFolder(const std::filesystem::path& folder);

// Throws Error for what is neither a file nor a level of the sequence's scene, "labels" or "none".
void CheckDetections(const std::string& detections, const std::filesystem::path& folder);

}  // namespace cvo
