// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/render_cache.h"

#include <cstdlib>

#include "core/base/error.h"
#include "core/files/temporary.h"

namespace cvo::synth {
namespace fs = std::filesystem;
namespace {

std::optional<fs::path> FolderFrom(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return fs::path(value);
}

// Renames the entry first, so that no other process finds a half-removed one.
void RemoveEntry(const fs::path& entry) {
  const fs::path aside = TemporaryName(entry, "damaged");
  std::error_code error;
  fs::remove_all(aside, error);
  fs::rename(entry, aside, error);
  if (error) {
    throw Error(StrCat(entry.string(), ": cannot remove the damaged folder: ", error.message()));
  }
  fs::remove_all(aside, error);
}

}  // namespace

fs::path CacheFolder() {
  if (const auto folder = FolderFrom("CLUSTERVO_CACHE")) return *folder;
  if (const auto folder = FolderFrom("XDG_CACHE_HOME")) return *folder / "clustervo";
  if (const auto folder = FolderFrom("HOME")) return *folder / ".cache" / "clustervo";
  ThrowError("cache folder", "none of CLUSTERVO_CACHE, XDG_CACHE_HOME and HOME",
             "CLUSTERVO_CACHE=<folder> in the environment");
}

fs::path ScenesFolder(const fs::path& cache) { return cache / "scenes"; }

void RemoveLeftoversOfCache(const fs::path& cache) {
  RemoveLeftovers(cache);
  RemoveEmptyFolders(ScenesFolder(cache));
  for (const fs::path& folder : {cache, ScenesFolder(cache)}) {
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      RemoveLeftovers(it->path());
    }
  }
}

std::optional<CachedRender> FindCachedRender(const fs::path& cache, const std::string& key,
                                             TaskPool& pool, const WorkHooks& hooks) {
  RemoveLeftoversOfCache(cache);
  const fs::path folder = cache / key;
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return std::nullopt;
  std::optional<std::string> damage;
  try {
    CachedRender entry = {folder, ReadManifest(folder)};
    const auto total = static_cast<int>(entry.manifest.files.size());
    int checked = 0;
    damage = FindDamage(folder, entry.manifest, pool,
                        [&] { hooks.Report(++checked, total, "verify the cached render"); });
    if (!damage) return entry;
  } catch (const Error& error) {
    damage = error.what();
  }
  if (hooks.notice) hooks.notice("cached render is damaged and drawn again: " + *damage);
  RemoveEntry(folder);
  return std::nullopt;
}

CachedRender AddCachedRender(const fs::path& cache, const std::string& key,
                             const std::function<Manifest(FolderBuild&)>& write) {
  FolderBuild build(cache / key);
  const Manifest manifest = write(build);
  build.MakeReadOnly();
  build.Commit(manifest, Existing::kKeep);
  return {cache / key, ReadManifest(cache / key)};
}

}  // namespace cvo::synth
