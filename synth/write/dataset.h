// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "synth/write/clean_render.h"
#include "synth/write/dataset_settings.h"

namespace cvo::synth {

// Frames [first, end) of a scene; without `end`, up to its last frame.
struct SceneFrames {
  int first = 0;
  std::optional<int> end;
};

struct RenderRequest {
  SceneFrames frames;
  std::optional<std::uint64_t> seed;         // overrides the scene's
  std::vector<std::string> detector_levels;  // empty: all
  bool flow = false;
  int threads = 2;
  WorkHooks hooks;
};

// A scene in the form that WriteDataset needs. `build_world` and `open_tools` are called only if
// the cache has no matching render.
struct DatasetSource {
  std::string scene;
  Json description;        // for scene.json
  std::string render_key;  // text that determines the render, except frames and program
  std::uint64_t seed = 0;
  SensorOptions sensor;
  std::vector<NamedDetector> detectors;
  RendererVersion version;
  std::function<World()> build_world;
  std::function<DrawingTools(const World&)> open_tools;
};

// Returns the cache key of the clean render. It does not depend on the seed, the detectors or the
// sensor (except motion blur), so requests that differ only in these share an entry.
std::string DrawingKey(const DatasetSource& source, const RenderRequest& request);
// Returns a key of everything that WriteDataset would write.
std::string DatasetKey(const DatasetSource& source, const RenderRequest& request);

// Throws Error if WriteDataset would refuse to replace what is at `folder`: a file, a folder with
// other content, or a dataset with files that its manifest does not list. Scenes in the cache are
// always replaced.
void RequireReplaceable(const std::filesystem::path& folder);

// Writes a sequence in the layout of KITTI odometry, plus the ground truth (synth/README.md). Takes
// the clean render from the cache, or renders it into the cache first. The folder appears complete
// or not at all, and only if RequireReplaceable allows it. Throws Stopped.
void WriteDataset(const DatasetSource& source, const RenderRequest& request,
                  const std::filesystem::path& folder);

}  // namespace cvo::synth
