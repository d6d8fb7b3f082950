// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "synth/write/clean_render.h"

namespace cvo::synth {

// Returns $CLUSTERVO_CACHE, else $XDG_CACHE_HOME/clustervo, else $HOME/.cache/clustervo. Throws
// Error if none of these variables is set.
std::filesystem::path CacheFolder();
// Folder of the rendered sequences of suites: <name>-<key>/<name>.
std::filesystem::path ScenesFolder(const std::filesystem::path& cache);

// Removes what killed processes left anywhere in the cache (core/files/temporary.h).
void RemoveLeftoversOfCache(const std::filesystem::path& cache);

// A cache entry: a complete sequence without the files that depend on a seed.
struct CachedRender {
  std::filesystem::path folder;
  Manifest manifest;
};

// Returns the entry with this key if there is one and none of its files has changed. A damaged
// entry is removed, and hooks.notice is called with the reason.
[[nodiscard]] std::optional<CachedRender> FindCachedRender(const std::filesystem::path& cache,
                                                           const std::string& key, TaskPool& pool,
                                                           const WorkHooks& hooks);

// Creates an entry with `write`, which fills the folder and returns its manifest without the list
// of files. If two processes create the entry at once, the first one is kept.
CachedRender AddCachedRender(const std::filesystem::path& cache, const std::string& key,
                             const std::function<Manifest(FolderBuild&)>& write);

}  // namespace cvo::synth
