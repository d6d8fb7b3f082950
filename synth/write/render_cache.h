// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

struct FileRecord {
  std::string name;  // relative to the folder, "image_0/000000.png"
  std::int64_t size_bytes = 0;
  std::string sha256;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("name", self.name);
    archive.Field("size_bytes", self.size_bytes);
    archive.Field("sha256", self.sha256);
  }
};

struct RenderedFrames {
  int first = 0;  // in the scene
  int count = 0;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("first", self.first);
    archive.Field("count", self.count);
  }
};

struct ImageSize {
  int width_px = 0;
  int height_px = 0;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("width_px", self.width_px);
    archive.Field("height_px", self.height_px);
  }
};

// Content and origin of a folder. It is written last, so a folder without it is incomplete.
struct Manifest {
  std::string scene;
  std::optional<std::uint64_t> seed;  // empty in the cache, where nothing depends on it
  RenderedFrames frames;
  ImageSize image;
  RigError rig_error;  // of the right camera; not in calib.txt
  RendererVersion renderer;
  std::string program_sources;    // SHA-256 of the sources that rendered and wrote it
  std::vector<FileRecord> files;  // all except the manifest, sorted by name

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("scene", self.scene);
    archive.Field("seed", self.seed);
    archive.Field("frames", self.frames);
    archive.Field("image", self.image);
    archive.Optional("rig_error", self.rig_error);
    archive.Field("renderer", self.renderer);
    archive.Field("program_sources", self.program_sources);
    archive.Field("files", self.files);
  }
};

inline constexpr char kManifestName[] = "manifest.json";

// Throws Error if the file is missing or is not a manifest of this program.
Manifest ReadManifest(const std::filesystem::path& folder);
std::string FormatManifest(const Manifest& manifest);

// Compares the files of a folder with its manifest. Describes the first file, by name, that is
// missing or differs in size or content; empty if all match.
std::optional<std::string> FindDamage(const std::filesystem::path& folder, const Manifest& manifest,
                                      TaskPool& pool);

enum class Existing { kKeep, kReplace };

// Builds a folder that appears complete or not at all: under a TemporaryName beside its target,
// renamed by Commit and otherwise removed by the destructor. The constructor first removes what
// dead processes left beside the target. Files may be added from several threads. All functions
// throw Error with the file and the reason.
class FolderBuild {
 public:
  explicit FolderBuild(const std::filesystem::path& target);
  ~FolderBuild();
  FolderBuild(const FolderBuild&) = delete;
  FolderBuild& operator=(const FolderBuild&) = delete;

  const std::filesystem::path& path() const { return temporary_; }

  void Write(const std::string& name, std::string_view bytes);
  // Adds a file of a complete folder under the same name, as a hard link, or as a copy if the
  // folder is on another file system.
  void Link(const std::filesystem::path& folder, const FileRecord& file);

  // Writes the manifest, which lists all files written and linked, and renames the folder to its
  // target. With kKeep, a target that has appeared in the meantime is kept and this build is
  // discarded.
  void Commit(Manifest manifest, Existing existing);
  // Makes the files read-only, because other folders will link to them.
  void MakeReadOnly();

 private:
  void Record(FileRecord file);

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::mutex mutex_;
  std::vector<FileRecord> files_;
};

// Thrown if the user asked to stop. No incomplete output is left behind.
class Stopped : public Error {
 public:
  using Error::Error;
};

// Callbacks for progress, cancellation and messages of a long operation. Never called concurrently.
struct WorkHooks {
  std::function<void(int done, int total, const std::string& stage)> progress;
  std::function<bool()> stop;                      // polled every few frames
  std::function<void(const std::string&)> notice;  // one line for the user

  void Report(int done, int total, const std::string& stage) const {
    if (progress) progress(done, total, stage);
  }
  void ThrowIfStopped() const {
    if (stop && stop()) throw Stopped("stopped before the sequence was complete");
  }
};

// Returns $CLUSTERVO_CACHE, else $XDG_CACHE_HOME/clustervo, else $HOME/.cache/clustervo. Throws
// Error if none of these variables is set.
std::filesystem::path CacheFolder();
// Folder of the rendered sequences of suites: <name>-<key>/<name>.
std::filesystem::path ScenesFolder(const std::filesystem::path& cache);

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
