// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "synth/scene/description.h"
#include "synth/write/dataset.h"

namespace cvo::synth {

// A renderer of the world, which must outlive it; belongs to the calling thread.
DrawingTools OpenRenderer(const World& world, int threads);

// The scene with its sensor and detectors read: throws Error for what those sections have wrong,
// and where nothing can draw (Renderer).
DatasetSource SourceOf(const SceneDescription& scene, const RenderRequest& request);

// Renders a scene into a folder, or takes it from the cache; see WriteDataset in dataset.h.
void WriteDataset(const SceneDescription& scene, const RenderRequest& request,
                  const std::filesystem::path& folder);

}  // namespace cvo::synth
