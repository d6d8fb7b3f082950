// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>

#include "synth/write/manifest.h"

namespace cvo::synth {

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

// Writes a file that must not exist yet. On failure, throws Error with the system's reason and
// leaves nothing behind.
void WriteNewFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace cvo::synth
