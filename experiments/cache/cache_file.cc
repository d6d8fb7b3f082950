// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/cache_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kTemporaryEnd = ".tmp";
// A writer has its lock by then.
constexpr std::chrono::seconds kYoung(60);

[[noreturn]] void ThrowErrno(const fs::path& file, const char* action, int error) {
  throw Error(StrCat(file.string(), ": cannot ", action, ": ", std::strerror(error)));
}

bool IsTemporary(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with('.') && name.ends_with(kTemporaryEnd);
}

// Writers hold a lock on their temporary, on a shared folder too, so one that can be locked is
// nobody's.
void RemoveIfAbandoned(const fs::path& temporary) {
  const int fd = ::open(temporary.c_str(), O_RDWR | O_CLOEXEC);
  if (fd < 0) return;
  if (::flock(fd, LOCK_EX | LOCK_NB) == 0) ::unlink(temporary.c_str());
  ::close(fd);
}

void RemoveAbandonedTemporaries(const fs::path& folder) {
  std::error_code error;
  const auto now = fs::file_time_type::clock::now();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!IsTemporary(entry.path())) continue;
    const auto written = entry.last_write_time(error);
    if (!error && now - written > kYoung) RemoveIfAbandoned(entry.path());
  }
}

void WriteAll(int fd, std::string_view bytes, std::uint64_t offset, const fs::path& file) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(fd, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) ThrowErrno(file, "write", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
}

}  // namespace

NewCacheFile::NewCacheFile(const fs::path& folder) : folder_(folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) ThrowErrno(folder, "create the folder", error.value());
  RemoveAbandonedTemporaries(folder);
  for (int attempt = 0;; ++attempt) {
    temporary_ = folder / StrCat(".", ::getpid(), "-", attempt, kTemporaryEnd);
    fd_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd_ >= 0) break;
    if (errno != EEXIST || attempt == 1000) ThrowErrno(folder, "write to the folder", errno);
  }
  // Without locks on this file system nobody can take one either, and the temporary is safe.
  (void)::flock(fd_, LOCK_EX | LOCK_NB);
}

NewCacheFile::~NewCacheFile() {
  ::unlink(temporary_.c_str());
  ::close(fd_);
}

void NewCacheFile::Append(std::string_view bytes) {
  WriteAll(fd_, bytes, size_bytes_, temporary_);
  size_bytes_ += bytes.size();
}

void NewCacheFile::ReplaceStart(std::string_view bytes) {
  Require(bytes.size() <= size_bytes_, "NewCacheFile: the start is longer than the file");
  WriteAll(fd_, bytes, 0, temporary_);
}

void NewCacheFile::Publish(const std::string& name) {
  const fs::path target = folder_ / name;
  if (::fsync(fd_) != 0) ThrowErrno(target, "write", errno);
  if (::link(temporary_.c_str(), target.c_str()) == 0 || errno == EEXIST) return;
  // File systems without hard links; whichever comes last stays then, and both hold the same.
  if (::rename(temporary_.c_str(), target.c_str()) != 0) ThrowErrno(target, "write", errno);
}

MappedFile::MappedFile(const fs::path& file) : path_(file) {
  fd_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd_ < 0) ThrowErrno(file, "read", errno);
  struct stat status {};
  void* data = MAP_FAILED;
  if (::fstat(fd_, &status) == 0 && status.st_size > 0) {
    size_bytes_ = static_cast<std::uint64_t>(status.st_size);
    data = ::mmap(nullptr, size_bytes_, PROT_READ, MAP_SHARED, fd_, 0);
  } else {
    errno = ENODATA;
  }
  if (data == MAP_FAILED) {
    const int error = errno;
    ::close(fd_);
    ThrowErrno(file, "read", error);
  }
  data_ = static_cast<const char*>(data);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : path_(std::move(other.path_)),
      fd_(std::exchange(other.fd_, -1)),
      size_bytes_(std::exchange(other.size_bytes_, 0)),
      data_(std::exchange(other.data_, nullptr)) {}

MappedFile::~MappedFile() {
  if (data_ != nullptr) ::munmap(const_cast<char*>(data_), size_bytes_);
  if (fd_ >= 0) ::close(fd_);
}

std::string MappedFile::Read(std::uint64_t offset, std::uint64_t count) const {
  struct stat status {};
  const bool whole =
      ::fstat(fd_, &status) == 0 && static_cast<std::uint64_t>(status.st_size) >= size_bytes_;
  if (!whole || count > size_bytes_ || offset > size_bytes_ - count) {
    ThrowError(path_.string(), StrCat(whole ? size_bytes_ : status.st_size, " bytes"),
               StrCat(count, " from the byte ", offset));
  }
  return {data_ + offset, count};
}

void MarkUsed(const fs::path& file) { (void)::utimensat(AT_FDCWD, file.c_str(), nullptr, 0); }

void TrimFolder(const fs::path& folder, std::uint64_t limit_bytes) {
  struct Entry {
    fs::file_time_type used;
    fs::path path;
    std::uint64_t size_bytes;
  };
  std::vector<Entry> entries;
  std::uint64_t total_bytes = 0;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    std::error_code gone;
    if (IsTemporary(file.path()) || !file.is_regular_file(gone)) continue;
    const Entry entry = {file.last_write_time(gone), file.path(), file.file_size(gone)};
    if (gone) continue;
    total_bytes += entry.size_bytes;
    entries.push_back(entry);
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.used, a.path) < std::tie(b.used, b.path);
  });
  for (const Entry& entry : entries) {
    if (total_bytes <= limit_bytes) return;
    if (::unlink(entry.path.c_str()) == 0 || errno == ENOENT) total_bytes -= entry.size_bytes;
  }
}

}  // namespace cvo
