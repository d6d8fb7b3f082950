// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/cache_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <tuple>
#include <vector>

#include "core/base/error.h"
#include "core/files/temporary.h"

namespace cvo {
namespace fs = std::filesystem;

NewCacheFile::NewCacheFile(const fs::path& folder) : folder_(folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) ThrowErrno(folder, "create the folder", error.value());
  RemoveLeftovers(folder);
  for (int attempt = 0;; ++attempt) {
    temporary_ = TemporaryName(folder / "new", std::to_string(attempt));
    file_ = FileDescriptor(temporary_, O_RDWR | O_CREAT | O_EXCL);
    if (file_.get() >= 0) break;
    if (errno != EEXIST || attempt == 1000) ThrowErrno(folder, "write to the folder", errno);
  }
}

NewCacheFile::~NewCacheFile() { ::unlink(temporary_.c_str()); }

void NewCacheFile::Append(std::string_view bytes) {
  WriteAll(file_, bytes, size_bytes_, temporary_);
  size_bytes_ += bytes.size();
}

void NewCacheFile::ReplaceStart(std::string_view bytes) {
  Require(bytes.size() <= size_bytes_, "NewCacheFile: the start is longer than the file");
  WriteAll(file_, bytes, 0, temporary_);
}

void NewCacheFile::Publish(const std::string& name) {
  const fs::path target = folder_ / name;
  if (SyncFile(file_) != 0) ThrowErrno(target, "write", errno);
  if (LinkFile(temporary_, target) == 0 || errno == EEXIST) return;
  // For file systems without hard links. The file of the last writer stays; all have the same
  // bytes.
  if (RenameFile(temporary_, target) != 0) ThrowErrno(target, "write", errno);
}

bool IsGone(const fs::path& file) {
  std::error_code error;
  return fs::status(file, error).type() == fs::file_type::not_found;
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
