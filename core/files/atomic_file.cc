// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/atomic_file.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace cvo {

namespace fs = std::filesystem;

void ThrowErrno(const fs::path& file, const char* action, int error) {
  throw Error(StrCat(file.string(), ": cannot ", action, ": ", std::strerror(error)));
}

FileDescriptor::FileDescriptor(const fs::path& path, int flags)
    : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}

FileDescriptor::~FileDescriptor() { Close(); }

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)) {}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

int FileDescriptor::Close() {
  const int fd = std::exchange(fd_, -1);
  return fd < 0 ? 0 : ::close(fd);
}

void WriteAll(const FileDescriptor& to, std::string_view bytes, std::uint64_t offset,
              const fs::path& file) {
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(to.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) ThrowErrno(file, "write", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
}

std::ptrdiff_t ReadUpTo(const FileDescriptor& from, char* bytes, std::size_t count,
                        std::uint64_t offset) {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t read =
        ::pread(from.get(), bytes + done, count - done, static_cast<off_t>(offset + done));
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) return -1;
    if (read == 0) break;
    done += static_cast<std::size_t>(read);
  }
  return static_cast<std::ptrdiff_t>(done);
}

namespace {

constexpr std::string_view kMark = ".tmp-";
constexpr std::size_t kDigits = 16;
constexpr std::string_view kHex = "0123456789abcdef";

// Whether the writer of a temporary must have been killed, as no write takes this long.
bool IsOld(const fs::path& path) {
  constexpr std::chrono::hours kLongest(24);
  std::error_code gone;
  const fs::file_time_type written = fs::last_write_time(path, gone);
  return !gone && fs::file_time_type::clock::now() - written > kLongest;
}

void RemoveWhere(const fs::path& folder, const std::function<bool(const fs::path&)>& goes) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (goes(it->path())) found.push_back(it->path());
  }
  for (const fs::path& path : found) fs::remove_all(path, error);
}

constexpr std::size_t kPendingBytes = std::size_t{1} << 18U;  // small parts are combined

void SyncFolder(const fs::path& folder) {
  const FileDescriptor opened(folder, O_RDONLY | O_DIRECTORY);
  if (opened.get() < 0) ThrowErrno(folder, "open", errno);
  // Some network file systems cannot sync a folder; their rename is durable by itself.
  if (::fsync(opened.get()) != 0 && errno != EINVAL) ThrowErrno(folder, "write", errno);
}

// Removes a file, and its subfolder of `folder` if that is then empty.
void RemoveFile(const fs::path& folder, const fs::path& name) {
  const fs::path file = folder / name;
  if (::unlink(file.c_str()) != 0 && errno != ENOENT) ThrowErrno(file, "remove", errno);
  std::error_code ignored;
  if (name.has_parent_path()) fs::remove(file.parent_path(), ignored);
}

}  // namespace

fs::path TemporaryName(const fs::path& target) {
  std::array<unsigned char, kDigits> bytes{};
  Require(::getrandom(bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()),
          "TemporaryName: the system gives no random bytes");
  std::string digits;
  for (const unsigned char byte : bytes) digits += kHex[byte % kHex.size()];
  return target.parent_path() / StrCat(".", target.filename().string(), kMark, digits);
}

bool IsTemporary(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::size_t mark = name.rfind(kMark);
  return name.starts_with('.') && mark != std::string::npos &&
         name.size() == mark + kMark.size() + kDigits &&
         name.find_first_not_of(kHex, mark + kMark.size()) == std::string::npos;
}

void RemoveLeftovers(const fs::path& folder) {
  RemoveWhere(folder, [](const fs::path& path) { return IsTemporary(path) && IsOld(path); });
}

void RemoveTemporaries(const fs::path& folder) { RemoveWhere(folder, IsTemporary); }

void RemoveTemporariesOf(const fs::path& target) {
  RemoveWhere(target.parent_path(),
              [begin = StrCat(".", target.filename().string())](const auto& path) {
                return IsTemporary(path) && path.filename().string().starts_with(begin);
              });
}

std::string HostName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

StagedFile::StagedFile(fs::path target) : target_(std::move(target)) {
  const fs::path temporary = TemporaryName(target_);
  file_ = FileDescriptor(temporary, O_WRONLY | O_CREAT | O_EXCL);
  if (file_.get() < 0) ThrowErrno(target_, "write", errno);
  temporary_ = temporary;
}

StagedFile::~StagedFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      file_(std::move(other.file_)),
      size_bytes_(other.size_bytes_),
      pending_(std::move(other.pending_)) {}

void StagedFile::Append(std::string_view bytes) {
  if (pending_.size() + bytes.size() <= kPendingBytes) {
    pending_ += bytes;
    return;
  }
  WritePending();
  WriteAll(file_, bytes, size_bytes_, target_);
  size_bytes_ += bytes.size();
}

void StagedFile::WritePending() {
  WriteAll(file_, pending_, size_bytes_, target_);
  size_bytes_ += pending_.size();
  pending_.clear();
}

void StagedFile::Complete() {
  WritePending();
  pending_.shrink_to_fit();
  if (::fsync(file_.get()) != 0 || file_.Close() != 0) ThrowErrno(target_, "write", errno);
}

void StagedFile::Publish() {
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) ThrowErrno(target_, "write", errno);
  temporary_.clear();
}

StagedFiles::~StagedFiles() {
  files_.clear();  // removes what was not published
  std::error_code ignored;
  for (const fs::path& path : subfolders_) fs::remove(path, ignored);  // fails if it is not empty
}

void StagedFiles::Add(const std::string& name, std::string_view content) {
  Add(name, [content](const TextSink& sink) { sink(content); });
}

void StagedFiles::Add(const std::string& name, const std::function<void(const TextSink&)>& write) {
  const fs::path parent = fs::path(name).parent_path();
  if (!parent.empty() && subfolders_.insert(folder_ / parent).second &&
      ::mkdir((folder_ / parent).c_str(), 0777) != 0 && errno != EEXIST) {
    ThrowErrno(folder_ / parent, "create the folder", errno);
  }
  StagedFile file(folder_ / name);
  write([&file](std::string_view part) { file.Append(part); });
  Add(std::move(file));
}

void StagedFiles::Add(StagedFile begun) {
  begun.Complete();
  files_.push_back(std::move(begun));
}

bool StagedFiles::Has(const std::string& name) const {
  return std::any_of(files_.begin(), files_.end(),
                     [&](const StagedFile& file) { return file.target() == folder_ / name; });
}

void StagedFiles::Publish(const std::vector<std::string>& stale) {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (i + 1 == files_.size()) {
      for (const std::string& name : stale) RemoveFile(folder_, name);
      for (const fs::path& path : subfolders_) SyncFolder(path);
    }
    files_[i].Publish();
  }
  SyncFolder(folder_);
}

void WriteFilesAtomically(const fs::path& folder, const std::vector<NamedContent>& files,
                          const std::vector<std::string>& stale) {
  StagedFiles staged(folder);
  for (const NamedContent& file : files) staged.Add(file.name, file.content);
  staged.Publish(stale);
}

OutputFolder::OutputFolder(fs::path folder, const std::vector<std::string>& names)
    : folder_(std::move(folder)) {
  std::error_code error;
  created_ = fs::create_directories(folder_, error);
  if (error) ThrowErrno(folder_, "create the folder", error.value());
  RemoveLeftovers(folder_);
  for (const std::string& name : names) {
    const bool is_folder = name.ends_with('/');
    const char* expected = is_folder ? "a folder or nothing" : "a file or nothing";
    const fs::path path = folder_ / name.substr(0, name.size() - (is_folder ? 1 : 0));
    const fs::file_status status = fs::symlink_status(path, error);
    const bool is_device = fs::is_other(fs::status(path, error));
    if (is_device) ThrowError(path.string(), "a pipe or a device", expected);
    if (fs::is_directory(status) && !is_folder) ThrowError(path.string(), "a folder", expected);
    if (fs::exists(status) && !fs::is_directory(status) && is_folder) {
      // Old files in the folder will be removed; behind a link, they would belong to someone else.
      ThrowError(path.string(), fs::is_symlink(status) ? "a link" : "a file", expected);
    }
    if (is_folder) RemoveLeftovers(path);
  }
  StagedFile probe(folder_ / (names.empty() ? "probe" : names.front()));
  probe.Append(std::string(4096, '\n'));
  probe.Complete();
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (created_) fs::remove(folder_, ignored);  // fails if it is not empty
}

}  // namespace cvo
