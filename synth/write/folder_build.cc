// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/folder_build.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/files/sha256.h"
#include "core/files/temporary.h"

namespace cvo::synth {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void ThrowErrno(const fs::path& path, const char* action, int error) {
  throw Error(StrCat(path.string(), ": cannot ", action, ": ", std::strerror(error)));
}

void CreateFolders(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) ThrowErrno(path, "create the folder", error.value());
}

// Creates a temporary folder with a unique name.
fs::path CreateTemporary(const fs::path& target) {
  for (int attempt = 0;; ++attempt) {
    const fs::path path = TemporaryName(target, std::to_string(attempt));
    if (::mkdir(path.c_str(), 0777) == 0) return path;
    if (errno != EEXIST || attempt == 1000) ThrowErrno(path, "create the folder", errno);
  }
}

void Rename(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) ThrowErrno(to, "write", errno);
}

}  // namespace

void WriteNewFile(const fs::path& path, std::string_view bytes) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (fd < 0) ThrowErrno(path, "write", errno);
  int error = 0;
  while (!bytes.empty() && error == 0) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (::close(fd) != 0 && error == 0) error = errno;
  if (error == 0) return;
  ::unlink(path.c_str());
  ThrowErrno(path, "write", error);
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
  WriteNewFile(temporary_ / name, bytes);
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
  WriteNewFile(temporary_ / kManifestName, FormatManifest(manifest));
  std::error_code ignored;
  if (fs::exists(target_, ignored)) {
    if (existing == Existing::kKeep) return;
    const fs::path aside = CreateTemporary(target_);
    Rename(target_, aside);  // replaces the empty folder `aside`
    try {
      Rename(temporary_, target_);
    } catch (...) {
      ::rename(aside.c_str(), target_.c_str());
      throw;
    }
    fs::remove_all(aside, ignored);
  } else if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
    const bool lost_a_race = errno == ENOTEMPTY || errno == EEXIST;
    if (existing == Existing::kKeep && lost_a_race) return;
    ThrowErrno(target_, "write", errno);
  }
  temporary_.clear();
}

}  // namespace cvo::synth
