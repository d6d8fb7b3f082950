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

// Frames [first, end) of a scene; no end: to its last.
struct SceneFrames {
  int first = 0;
  std::optional<int> end;
};

struct RenderRequest {
  SceneFrames frames;
  std::optional<std::uint64_t> seed;         // instead of the scene's
  std::vector<std::string> detector_levels;  // empty: all
  bool flow = false;
  int threads = 2;
  WorkHooks hooks;
};

// A scene as WriteDataset needs it; what draws is asked for only where the cache has nothing.
struct DatasetSource {
  std::string scene;
  Json description;        // for scene.json
  std::string render_key;  // text that decides what is drawn, but frames and program
  std::uint64_t seed = 0;
  SensorOptions sensor;
  std::vector<NamedDetector> detectors;
  RendererVersion version;
  std::function<World()> build_world;
  std::function<DrawingTools(const World&)> open_tools;
};

// Of what is drawn: equal where the cache holds one for the other, whatever the seed, sensor and
// detectors.
std::string DrawingKey(const DatasetSource& source, const RenderRequest& request);
// Of all bytes that WriteDataset would write.
std::string DatasetKey(const DatasetSource& source, const RenderRequest& request);

// Throws Error where WriteDataset would not replace what is there: a file, a folder of other
// things, or a data set with files that its manifest does not name. Scenes of the cache always are
// replaced.
void RequireReplaceable(const std::filesystem::path& folder);

// Writes a folder in the layout of KITTI odometry with the ground truth beside it
// (synth/README.md), from the cache where it holds the clean render. The folder appears complete or
// not at all, and only where RequireReplaceable allows it. Throws Stopped.
void WriteDataset(const DatasetSource& source, const RenderRequest& request,
                  const std::filesystem::path& folder);

}  // namespace cvo::synth
