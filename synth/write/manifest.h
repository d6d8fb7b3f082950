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
  std::string name;  // relative to the folder, "image_0/000000.png"
  std::int64_t size_bytes = 0;
  std::string sha256;
};

// Content and origin of a folder. It is written last, so a folder without it is incomplete.
struct Manifest {
  std::string scene;
  std::optional<std::uint64_t> seed;  // empty in the cache, where nothing depends on it
  int first_frame = 0;                // in the scene
  int frames = 0;
  int width_px = 0;
  int height_px = 0;
  RigError rig_error;  // of the right camera; not in calib.txt
  RendererVersion renderer;
  std::string program_sources;    // SHA-256 of the sources that rendered and wrote it
  std::vector<FileRecord> files;  // all except the manifest, sorted by name
};

inline constexpr char kManifestName[] = "manifest.json";

// Throws Error if the file is missing or is not a manifest of this program.
Manifest ReadManifest(const std::filesystem::path& folder);
std::string FormatManifest(const Manifest& manifest);

// Compares the files of a folder with its manifest. Describes the first file, by name, that is
// missing or differs in size or content; empty if all match. `done` is called after each file,
// never concurrently.
std::optional<std::string> FindDamage(const std::filesystem::path& folder, const Manifest& manifest,
                                      TaskPool& pool, const std::function<void()>& done = {});

}  // namespace cvo::synth
