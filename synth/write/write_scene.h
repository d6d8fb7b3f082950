// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "synth/scene/description.h"
#include "synth/write/dataset.h"

namespace cvo::synth {

// Opens a renderer of `world`, which must outlive it. It belongs to the calling thread.
DrawingTools OpenRenderer(const World& world, int threads);

// Prepares a scene for WriteDataset. Throws Error for a mistake in its sensor or detector section,
// and if this build cannot render (see Renderer).
DatasetSource SourceOf(const SceneDescription& scene, const RenderRequest& request);

// Renders a scene into a folder, or takes it from the cache; see WriteDataset in dataset.h.
void WriteDataset(const SceneDescription& scene, const RenderRequest& request,
                  const std::filesystem::path& folder);

}  // namespace cvo::synth
