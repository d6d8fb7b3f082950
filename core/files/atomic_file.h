// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/disk.h"

namespace cvo {

struct NamedContent {
  std::string name;  // within the folder; "a/b": in a folder in it, made where there is none
  std::string content;
};

// A file that is written as its content comes, under a temporary name beside its own; it goes away
// unless it is published. All throw Error naming the file and why.
class StagedFile {
 public:
  explicit StagedFile(std::filesystem::path target);
  ~StagedFile();
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  const std::filesystem::path& target() const { return target_; }

  void Append(std::string_view bytes);
  // Checked and synced to the disk: no more to come.
  void Complete();
  void Publish();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  FileDescriptor file_;
  std::uint64_t size_bytes_ = 0;
};

// Writes files that belong together: each under a temporary name beside its own, checked and synced
// to the disk; only when all of them are complete are they renamed, the last of the list last and
// after the files of `stale` are gone. Throws Error naming the file and why. A final name holds
// what it held before or the complete new content, and no temporary is left behind. `begun` is one
// more of them.
void WriteFilesAtomically(const std::filesystem::path& folder,
                          const std::vector<NamedContent>& files,
                          const std::vector<std::string>& stale = {},
                          std::optional<StagedFile> begun = {});

// A folder that results will be written to. Creates it where there is none, and proves that files
// of these names can be written ("a/": a folder): throws Error naming what is in the way. A folder
// that it created and that is still empty at the end goes away again.
class OutputFolder {
 public:
  OutputFolder(std::filesystem::path folder, const std::vector<std::string>& names);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
  bool created_ = false;
};

}  // namespace cvo
