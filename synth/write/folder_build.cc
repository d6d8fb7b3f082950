// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/folder_build.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>

#include "core/base/error.h"
#include "core/files/number.h"
#include "core/files/sha256.h"

namespace cvo::synth {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kMark = ".tmp-";
constexpr std::chrono::hours kSilence(24);  // no render takes so long

[[noreturn]] void ThrowErrno(const fs::path& path, const char* action, int error) {
  throw Error(StrCat(path.string(), ": cannot ", action, ": ", std::strerror(error)));
}

std::string HostName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

struct Owner {
  std::string_view host;
  std::int64_t process = 0;
};

// Of "name.tmp-<host>.<pid>-<end>"; empty where the name is another.
std::optional<Owner> OwnerOf(std::string_view name) {
  const std::size_t mark = name.rfind(kMark);
  if (mark == std::string_view::npos) return std::nullopt;
  const std::string_view tail = name.substr(mark + kMark.size());
  const std::size_t dash = tail.rfind('-');
  const std::size_t dot = tail.substr(0, dash).rfind('.');
  if (dash == std::string_view::npos || dot == std::string_view::npos) return std::nullopt;
  const auto process = ParseInteger(tail.substr(dot + 1, dash - dot - 1));
  if (!process || *process <= 0) return std::nullopt;
  return Owner{tail.substr(0, dot), *process};
}

// Of a process of another computer nothing is known but how long it has been silent.
bool IsStale(const Owner& owner, const fs::path& temporary) {
  if (owner.host == HostName()) {
    return ::kill(static_cast<pid_t>(owner.process), 0) != 0 && errno == ESRCH;
  }
  std::error_code gone;
  const fs::file_time_type written = fs::last_write_time(temporary, gone);
  return !gone && fs::file_time_type::clock::now() - written > kSilence;
}

void CreateFolders(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) ThrowErrno(path, "create the folder", error.value());
}

// A name that nobody else has.
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

fs::path TemporaryName(const fs::path& target, const std::string& end) {
  return StrCat(target.string(), kMark, HostName(), ".", ::getpid(), "-", end);
}

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

void RemoveStaleTemporaries(const fs::path& folder, const std::string& prefix) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const std::optional<Owner> owner = OwnerOf(name);
    if (owner && IsStale(*owner, entry.path())) fs::remove_all(entry.path(), ignored);
  }
}

FolderBuild::FolderBuild(const fs::path& target)
    : target_(fs::absolute(target).lexically_normal()) {
  if (target_.filename().empty()) target_ = target_.parent_path();
  CreateFolders(target_.parent_path());
  RemoveStaleTemporaries(target_.parent_path(), target_.filename().string() + std::string(kMark));
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
    Rename(target_, aside);  // replaces the empty folder
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
