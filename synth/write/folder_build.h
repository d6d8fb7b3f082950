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

// A folder of files that appears complete or not at all: built under a TemporaryName beside its
// target, renamed at the end, removed otherwise. What dead processes left
// beside it goes away first. Files may be added from several threads; throws Error naming the file
// and why.
class FolderBuild {
 public:
  explicit FolderBuild(const std::filesystem::path& target);
  ~FolderBuild();
  FolderBuild(const FolderBuild&) = delete;
  FolderBuild& operator=(const FolderBuild&) = delete;

  const std::filesystem::path& path() const { return temporary_; }

  void Write(const std::string& name, std::string_view bytes);
  // The file of a complete folder under the same name: linked, or copied across file systems.
  void Link(const std::filesystem::path& folder, const FileRecord& file);

  // Adds the manifest with what was written and linked, then renames. kKeep: where the target came
  // into being meanwhile it stays, and this build goes away.
  void Commit(Manifest manifest, Existing existing);
  // Read-only: other folders link these files.
  void MakeReadOnly();

 private:
  void Record(FileRecord file);

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::mutex mutex_;
  std::vector<FileRecord> files_;
};

// Writes a new file. Throws Error with the system's reason; nothing is left then.
void WriteNewFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace cvo::synth
