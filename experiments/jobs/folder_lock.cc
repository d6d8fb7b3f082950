// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "core/base/error.h"
#include "core/files/host_name.h"

namespace cvo {
namespace {

std::string Holder(int fd) {
  std::array<char, 400> text{};
  const ssize_t size = ::pread(fd, text.data(), text.size(), 0);
  const std::string holder(text.data(), static_cast<std::size_t>(size > 0 ? size : 0));
  return holder.empty() ? "another process" : holder.substr(0, holder.find('\n'));
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& file)
    : fd_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  const int open_error = errno;
  if (fd_ < 0) throw Error(StrCat(file.string(), ": cannot write: ", std::strerror(open_error)));
  if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    const std::string holder = Holder(fd_);
    ::close(fd_);
    if (error != EWOULDBLOCK) {
      throw Error(StrCat(file.string(), ": cannot lock: ", std::strerror(error)));
    }
    ThrowError(file.parent_path().string(), StrCat("in use by ", holder),
               "a folder not in use by another run");
  }
  // Used only in the message above, so a full disk is no reason to fail.
  const std::string me = StrCat("process ", ::getpid(), " on ", HostName(), '\n');
  if (::ftruncate(fd_, 0) == 0) {
    [[maybe_unused]] const ssize_t written = ::pwrite(fd_, me.data(), me.size(), 0);
  }
}

FolderLock::~FolderLock() { ::close(fd_); }

}  // namespace cvo
