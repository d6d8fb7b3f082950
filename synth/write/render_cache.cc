// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/render_cache.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json_record.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"

namespace cvo::synth {
namespace {

namespace fs = std::filesystem;

constexpr int kSchemaVersion = 1;
constexpr char kKind[] = "clustervo synthetic sequence";

std::optional<std::string> FileDamage(const std::filesystem::path& path, const FileRecord& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) return path.string() + " is missing";
  if (static_cast<std::int64_t>(size) != file.size_bytes) {
    return StrCat(path.string(), " has ", size, " bytes instead of ", file.size_bytes);
  }
  if (Sha256Hex(ReadFileBytes(path)) != file.sha256) {
    return path.string() + " has changed since it was written";
  }
  return std::nullopt;
}

void CreateFolders(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) ThrowErrno(path, "create the folder", error.value());
}

// Creates a temporary folder with a unique name.
fs::path CreateTemporary(const fs::path& target) {
  const fs::path path = TemporaryName(target);
  if (::mkdir(path.c_str(), 0777) != 0) ThrowErrno(path, "create the folder", errno);
  return path;
}

void Rename(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) ThrowErrno(to, "write", errno);
}

// Swaps two folders: at once, so that no other process misses one, where the file system can.
void Exchange(const fs::path& one, const fs::path& other) {
  if (::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno != EINVAL) ThrowErrno(other, "write", errno);
  const fs::path aside = CreateTemporary(other);
  Rename(other, aside);  // replaces the empty folder `aside`
  try {
    Rename(one, other);
  } catch (...) {
    ::rename(aside.c_str(), other.c_str());
    throw;
  }
  Rename(aside, one);
}

std::optional<fs::path> FolderFrom(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return fs::path(value);
}

// Renames the entry first, so that no other process finds a half-removed one.
void RemoveEntry(const fs::path& entry) {
  const fs::path aside = TemporaryName(entry);
  std::error_code error;
  fs::rename(entry, aside, error);
  if (error) {
    throw Error(StrCat(entry.string(), ": cannot remove the damaged folder: ", error.message()));
  }
  fs::remove_all(aside, error);
}

}  // namespace

std::string FormatManifest(const Manifest& manifest) {
  JsonWriter writer;
  writer.Field("kind", std::string(kKind));
  writer.Field("schema_version", kSchemaVersion);
  Manifest::VisitFields(manifest, writer);
  return DumpJson(writer.Take());
}

Manifest ReadManifest(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kManifestName;
  const Json json = ReadJson(path);
  if (!json.is_object() || json.value("kind", Json()) != kKind ||
      json.value("schema_version", Json()) != kSchemaVersion) {
    ThrowError(path.string(), "another JSON file",
               StrCat("a manifest \"", kKind, "\", ", kSchemaVersion));
  }
  return FromJson<Manifest>(json, path.string());
}

std::optional<std::string> FindDamage(const std::filesystem::path& folder, const Manifest& manifest,
                                      TaskPool& pool) {
  std::vector<std::optional<std::string>> damages(manifest.files.size());
  pool.ParallelFor(static_cast<int>(damages.size()), [&](int i) {
    const FileRecord& file = manifest.files[static_cast<std::size_t>(i)];
    damages[static_cast<std::size_t>(i)] = FileDamage(folder / file.name, file);
  });
  for (const auto& damage : damages) {
    if (damage) return damage;
  }
  return std::nullopt;
}

FolderBuild::FolderBuild(const fs::path& target)
    : target_(fs::absolute(target).lexically_normal()) {
  if (target_.filename().empty()) target_ = target_.parent_path();
  CreateFolders(target_.parent_path());
  RemoveLeftovers(target_.parent_path());
  temporary_ = CreateTemporary(target_);
}

FolderBuild::~FolderBuild() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void FolderBuild::Record(FileRecord file) {
  const std::lock_guard lock(mutex_);
  files_.push_back(std::move(file));
}

void FolderBuild::Write(const std::string& name, std::string_view bytes) {
  CreateFolders((temporary_ / name).parent_path());
  WriteFileBytes(temporary_ / name, bytes);
  Record({name, static_cast<std::int64_t>(bytes.size()), Sha256Hex(bytes)});
}

void FolderBuild::Link(const fs::path& folder, const FileRecord& file) {
  const fs::path from = folder / file.name;
  const fs::path to = temporary_ / file.name;
  CreateFolders(to.parent_path());
  std::error_code error;
  fs::create_hard_link(from, to, error);
  if (error) {
    error.clear();
    fs::copy_file(from, to, error);
    if (error) ThrowErrno(to, "write", error.value());
  }
  Record(file);
}

void FolderBuild::MakeReadOnly() {
  for (const FileRecord& file : files_) {
    const fs::path path = temporary_ / file.name;
    if (::chmod(path.c_str(), 0444) != 0) ThrowErrno(path, "protect the file", errno);
  }
}

void FolderBuild::Commit(Manifest manifest, Existing existing) {
  std::sort(files_.begin(), files_.end(),
            [](const FileRecord& a, const FileRecord& b) { return a.name < b.name; });
  manifest.files = files_;
  WriteFileBytes(temporary_ / kManifestName, FormatManifest(manifest));
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
    if (errno != ENOTEMPTY && errno != EEXIST) ThrowErrno(target_, "write", errno);
    if (existing == Existing::kKeep) return;
    Exchange(temporary_, target_);
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
  }
  temporary_.clear();
}

fs::path CacheFolder() {
  if (const auto folder = FolderFrom("CLUSTERVO_CACHE")) return *folder;
  if (const auto folder = FolderFrom("XDG_CACHE_HOME")) return *folder / "clustervo";
  if (const auto folder = FolderFrom("HOME")) return *folder / ".cache" / "clustervo";
  ThrowError("cache folder", "none of CLUSTERVO_CACHE, XDG_CACHE_HOME and HOME",
             "CLUSTERVO_CACHE=<folder> in the environment");
}

fs::path ScenesFolder(const fs::path& cache) { return cache / "scenes"; }

std::optional<CachedRender> FindCachedRender(const fs::path& cache, const std::string& key,
                                             TaskPool& pool, const WorkHooks& hooks) {
  const fs::path folder = cache / key;
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return std::nullopt;
  std::optional<std::string> damage;
  try {
    CachedRender entry = {folder, ReadManifest(folder)};
    damage = FindDamage(folder, entry.manifest, pool);
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
