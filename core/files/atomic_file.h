// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/files/text_file.h"

// Files that are complete or absent, whatever call fails and whenever the process is killed.
namespace cvo {

// Throws Error "<file>: cannot <action>: <the system's reason>".
[[noreturn]] void ThrowErrno(const std::filesystem::path& file, const char* action, int error);

// An open file. get() is negative if it could not be opened; errno then gives the reason.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  FileDescriptor(const std::filesystem::path& path, int flags);
  ~FileDescriptor();
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;

  int get() const { return fd_; }
  // Returns zero, or a negative value with errno set. Some file systems report a failed write only
  // here.
  int Close();

 private:
  int fd_ = -1;
};

// Writes all bytes at an offset. Throws Error naming `file`.
void WriteAll(const FileDescriptor& to, std::string_view bytes, std::uint64_t offset,
              const std::filesystem::path& file);
// Reads at most `count` bytes at an offset, fewer only at the end of the file. Returns their
// number, or a negative value with errno set if it cannot be read.
std::ptrdiff_t ReadUpTo(const FileDescriptor& from, char* bytes, std::size_t count,
                        std::uint64_t offset);

// Returns a temporary name for a file or folder that must be either complete under its own name or
// absent. Until it is complete, it has this name beside its target:
// "<folder>/.<name>.tmp-<random>".
std::filesystem::path TemporaryName(const std::filesystem::path& target);

bool IsTemporary(const std::filesystem::path& file);

// Removes temporaries that have not been modified for a day: their writers were killed. Never
// throws.
void RemoveLeftovers(const std::filesystem::path& folder);

// Remove all temporaries in a folder, or those of one file. Only for their only writer.
void RemoveTemporaries(const std::filesystem::path& folder);
void RemoveTemporariesOf(const std::filesystem::path& target);

// Name of this machine; "unknown" if it cannot be determined.
std::string HostName();

struct NamedContent {
  // Relative to the folder. "a/b" is in a subfolder, which is created if it does not exist.
  std::string name;
  std::string content;
};

// A file that is written piece by piece under a temporary name beside its target, and removed
// unless it is published. All functions throw Error naming the file and the reason.
class StagedFile {
 public:
  explicit StagedFile(std::filesystem::path target);
  ~StagedFile();
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  const std::filesystem::path& target() const { return target_; }

  void Append(std::string_view bytes);
  std::uint64_t size_bytes() const { return size_bytes_ + pending_.size(); }
  // Writes the remaining bytes, checks for errors and syncs the file to disk. Nothing may be
  // appended afterwards.
  void Complete();
  void Publish();

 private:
  void WritePending();

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  FileDescriptor file_;
  std::uint64_t size_bytes_ = 0;  // written to the file so far
  std::string pending_;           // bytes to be written after them
};

// Files of a folder that belong together. As it is added, each is written under a temporary name
// beside its target, checked and synced to disk, so that only one needs to be in memory. Throws
// Error naming the file and the reason. Files that are not published are removed.
class StagedFiles {
 public:
  explicit StagedFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~StagedFiles();  // removes subfolders that are still empty
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  // `name` is like that of a NamedContent.
  void Add(const std::string& name, std::string_view content);
  // Adds what `write` passes to the sink. Only part of it is in memory at a time.
  void Add(const std::string& name, const std::function<void(const TextSink&)>& write);
  // Adds a file of the same folder that was begun earlier.
  void Add(StagedFile begun);
  bool Has(const std::string& name) const;

  // Renames the files to their targets in the order in which they were added. The last one is
  // renamed after the files of `stale` have been removed. At any time, a target name holds what it
  // held before or the complete new content.
  void Publish(const std::vector<std::string>& stale = {});

 private:
  std::filesystem::path folder_;
  std::set<std::filesystem::path> subfolders_;
  std::vector<StagedFile> files_;
};

// Writes all of the files, with StagedFiles.
void WriteFilesAtomically(const std::filesystem::path& folder,
                          const std::vector<NamedContent>& files,
                          const std::vector<std::string>& stale = {});

// A folder for results. Creates it if it does not exist, and verifies that files of these names can
// be written in it ("a/" is a subfolder): throws Error naming what is in the way. If it created the
// folder and the folder is still empty at the end, removes it.
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
