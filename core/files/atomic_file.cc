// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/files/disk.h"
#include "core/files/temporary.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

// A complete and synced file under a temporary name; removed again unless it is renamed.
class StagedFile {
 public:
  StagedFile(const fs::path& folder, const NamedContent& file) : target_(folder / file.name) {
    FileDescriptor out = Create();
    try {
      WriteAll(out, file.content, 0, target_);
      if (SyncFile(out) != 0 || out.Close() != 0) ThrowErrno(target_, "write", errno);
    } catch (...) {
      ::unlink(temporary_.c_str());
      throw;
    }
  }
  ~StagedFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }
  StagedFile(StagedFile&& other) noexcept
      : target_(std::move(other.target_)), temporary_(std::move(other.temporary_)) {
    other.temporary_.clear();
  }
  StagedFile& operator=(StagedFile&&) = delete;

  void Publish() {
    if (RenameFile(temporary_, target_) != 0) ThrowErrno(target_, "write", errno);
    temporary_.clear();
  }

 private:
  // A killed process of the same number may have left some behind.
  FileDescriptor Create() {
    for (int attempt = 0;; ++attempt) {
      temporary_ = TemporaryName(target_, std::to_string(attempt));
      FileDescriptor out(temporary_, O_WRONLY | O_CREAT | O_EXCL);
      if (out.get() >= 0) return out;
      if (errno != EEXIST || attempt == 1000) ThrowErrno(target_, "write", errno);
    }
  }

  fs::path target_;
  fs::path temporary_;
};

void SyncFolder(const fs::path& folder) {
  const FileDescriptor opened(folder, O_RDONLY | O_DIRECTORY);
  if (opened.get() < 0) ThrowErrno(folder, "open", errno);
  // Some network file systems cannot sync a folder; their rename is durable by itself.
  if (SyncFile(opened) != 0 && errno != EINVAL) ThrowErrno(folder, "write", errno);
}

// The folders within a folder that files go to. Those that are empty at the end go away again.
class Subfolders {
 public:
  Subfolders(const fs::path& folder, const std::vector<NamedContent>& files) {
    for (const NamedContent& file : files) {
      const fs::path parent = fs::path(file.name).parent_path();
      if (parent.empty() || !paths_.insert(folder / parent).second) continue;
      if (::mkdir((folder / parent).c_str(), 0777) != 0 && errno != EEXIST) {
        ThrowErrno(folder / parent, "create the folder", errno);
      }
    }
  }
  ~Subfolders() {
    std::error_code ignored;
    for (const fs::path& path : paths_) fs::remove(path, ignored);  // refuses where it is not empty
  }
  Subfolders(const Subfolders&) = delete;
  Subfolders& operator=(const Subfolders&) = delete;

  void Sync() const {
    for (const fs::path& path : paths_) SyncFolder(path);
  }

 private:
  std::set<fs::path> paths_;
};

// And the folder in `folder` that it is in, once that is empty.
void RemoveFile(const fs::path& folder, const fs::path& name) {
  const fs::path file = folder / name;
  if (::unlink(file.c_str()) != 0 && errno != ENOENT) ThrowErrno(file, "remove", errno);
  std::error_code ignored;
  if (name.has_parent_path()) fs::remove(file.parent_path(), ignored);
}

}  // namespace

void WriteFilesAtomically(const fs::path& folder, const std::vector<NamedContent>& files,
                          const std::vector<std::string>& stale) {
  const Subfolders subfolders(folder, files);
  std::vector<StagedFile> staged;
  staged.reserve(files.size());
  for (const NamedContent& file : files) staged.emplace_back(folder, file);
  for (std::size_t i = 0; i < staged.size(); ++i) {
    if (i + 1 == staged.size()) {
      for (const std::string& name : stale) RemoveFile(folder, name);
      subfolders.Sync();
    }
    staged[i].Publish();
  }
  SyncFolder(folder);
}

OutputFolder::OutputFolder(fs::path folder, const std::vector<std::string>& names)
    : folder_(std::move(folder)) {
  std::error_code error;
  created_ = fs::create_directories(folder_, error);
  if (error) ThrowErrno(folder_, "create the folder", error.value());
  RemoveLeftovers(folder_);
  for (const std::string& name : names) {
    const bool wanted = name.ends_with('/');
    const fs::path path = folder_ / name.substr(0, name.size() - (wanted ? 1 : 0));
    const fs::file_status status = fs::symlink_status(path, error);
    if (fs::is_directory(status) != wanted && fs::exists(status)) {
      // Old files of a folder are removed, and behind a link they are somebody else's.
      const bool link = wanted && fs::is_symlink(status);
      ThrowError(path.string(),
                 link     ? "a link"
                 : wanted ? "a file"
                          : "a folder",
                 wanted ? "a folder or nothing" : "a file or nothing");
    }
    if (fs::is_other(fs::status(path, error))) {
      ThrowError(path.string(), "a pipe or a device", "a file or nothing");
    }
    if (wanted) RemoveLeftovers(path);
  }
  const StagedFile probe(folder_,
                         {names.empty() ? "probe" : names.front(), std::string(4096, '\n')});
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (created_) fs::remove(folder_, ignored);  // refuses where it is not empty
}

}  // namespace cvo
