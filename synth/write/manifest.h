// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/task_pool.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

struct FileRecord {
  std::string name;  // within the folder, "image_0/000000.png"
  std::int64_t size_bytes = 0;
  std::string sha256;
};

// What a folder holds and where it comes from. Written last: a folder without it is not complete.
struct Manifest {
  std::string scene;
  std::optional<std::uint64_t> seed;  // none in the cache: nothing there depends on it
  int first_frame = 0;                // of the scene
  int frames = 0;
  int width_px = 0;
  int height_px = 0;
  RigError rig_error;  // of the right camera; calib.txt does not know it
  RendererVersion renderer;
  std::string program_sources;    // SHA-256 of what drew and wrote
  std::vector<FileRecord> files;  // all but the manifest, by name
};

inline constexpr char kManifestName[] = "manifest.json";

// Throws Error where the file is missing or not a manifest of ours.
Manifest ReadManifest(const std::filesystem::path& folder);
std::string FormatManifest(const Manifest& manifest);

// What is wrong with the folder's files against their manifest: the first by name that is missing,
// has another size or other content. `done` is told of each file.
std::optional<std::string> FindDamage(const std::filesystem::path& folder, const Manifest& manifest,
                                      TaskPool& pool, const std::function<void()>& done = {});

}  // namespace cvo::synth
