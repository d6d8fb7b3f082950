// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "synth/write/clean_render.h"

namespace cvo::synth {

// CLUSTERVO_CACHE, else clustervo in XDG_CACHE_HOME, else in ~/.cache. Throws Error where none of
// these variables is set.
std::filesystem::path CacheFolder();
// Rendered sequences of suites: <name>-<key>/<name>.
std::filesystem::path ScenesFolder(const std::filesystem::path& cache);

// Removes what processes that were killed left anywhere in the cache (core/files/temporary.h).
void RemoveLeftoversOfCache(const std::filesystem::path& cache);

// A complete sequence without what depends on a seed.
struct CachedRender {
  std::filesystem::path folder;
  Manifest manifest;
};

// The entry under a key, if there is one and none of its files changed. A damaged one is removed
// and hooks.notice told why.
[[nodiscard]] std::optional<CachedRender> FindCachedRender(const std::filesystem::path& cache,
                                                           const std::string& key, TaskPool& pool,
                                                           const WorkHooks& hooks);

// Builds the entry by `write` (which fills the folder and returns its manifest without files). Two
// processes may do so at once: the entry of the first stays.
CachedRender AddCachedRender(const std::filesystem::path& cache, const std::string& key,
                             const std::function<Manifest(FolderBuild&)>& write);

}  // namespace cvo::synth
