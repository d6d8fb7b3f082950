// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/files/disk.h"
#include "core/files/text_sink.h"

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
  void WritePending();

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  FileDescriptor file_;
  std::uint64_t size_bytes_ = 0;  // of the file
  std::string pending_;           // behind them
};

// Files of a folder that belong together: each is written under a temporary name beside its own,
// checked and synced to the disk as it is added, so that only one need be in memory. Throws Error
// naming the file and why; what was not published goes away.
class StagedFiles {
 public:
  explicit StagedFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~StagedFiles();  // folders in it that are still empty go away
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  // `name` as of a NamedContent.
  void Add(const std::string& name, std::string_view content);
  // What `write` gives the sink: a part of it at a time is in memory.
  void Add(const std::string& name, const std::function<void(const TextSink&)>& write);
  // One that was begun before, in the same folder.
  void Add(StagedFile begun);
  bool Has(const std::string& name) const;

  // Renames them in the order in which they were added, the last one after the files of `stale` are
  // gone: a final name holds what it held before or the complete new content.
  void Publish(const std::vector<std::string>& stale = {});

 private:
  std::filesystem::path folder_;
  std::set<std::filesystem::path> subfolders_;
  std::vector<StagedFile> files_;
};

// All of them, as StagedFiles.
void WriteFilesAtomically(const std::filesystem::path& folder,
                          const std::vector<NamedContent>& files,
                          const std::vector<std::string>& stale = {});

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
