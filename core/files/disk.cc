// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/disk.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include "core/base/error.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

enum class FaultKind { kNone, kFail, kShort, kKill };

struct FaultPoint {
  FaultKind kind = FaultKind::kNone;
  std::string call;
  std::uint64_t number = 0;
  std::uint64_t* calls = nullptr;  // counter of the calls of all processes so far
};

FaultPoint FaultFromEnvironment() {
  const char* variable = std::getenv("CLUSTERVO_FAULT");
  if (variable == nullptr) return {};
  const std::string text = variable;
  const std::size_t call = text.find(',') + 1;
  const std::size_t number = text.find(',', call) + 1;
  const std::size_t file = text.find(',', number) + 1;
  Require(call > 0 && number > call && file > number,
          "CLUSTERVO_FAULT: expected <fault>,<call>,<n>,<file>");
  const int fd = ::open(text.c_str() + file, O_RDWR | O_CLOEXEC);
  void* const calls =
      ::mmap(nullptr, sizeof(std::uint64_t), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  ::close(fd);
  Require(calls != MAP_FAILED, "CLUSTERVO_FAULT: the file cannot be mapped");
  const std::string kind = text.substr(0, call - 1);
  return {kind == "kill"    ? FaultKind::kKill
          : kind == "short" ? FaultKind::kShort
                            : FaultKind::kFail,
          text.substr(call, number - 1 - call), std::strtoull(text.c_str() + number, nullptr, 10),
          static_cast<std::uint64_t*>(calls)};
}

// Returns the fault for the call that is about to be made.
FaultKind NextFault(std::string_view call) {
  static const FaultPoint point = FaultFromEnvironment();
  if (point.kind == FaultKind::kNone || point.call != call) return FaultKind::kNone;
  if (std::atomic_ref(*point.calls).fetch_add(1) + 1 != point.number) return FaultKind::kNone;
  if (point.kind == FaultKind::kKill) ::raise(SIGKILL);
  return point.kind;
}

// Whether the call is to fail. If so, sets errno to `error`.
bool Fails(std::string_view call, int error) {
  if (NextFault(call) != FaultKind::kFail) return false;
  errno = error;
  return true;
}

// Transfers once: all bytes or, for a short transfer, half of them. To fail, sets errno to `error`.
template <typename Transfer>
ssize_t TransferOnce(std::string_view call, const Transfer& transfer, std::size_t count,
                     int error) {
  const FaultKind fault = NextFault(call);
  if (fault == FaultKind::kFail) {
    errno = error;
    return -1;
  }
  return transfer(fault == FaultKind::kShort ? (count + 1) / 2 : count);
}

}  // namespace

void ThrowErrno(const fs::path& file, const char* action, int error) {
  throw Error(StrCat(file.string(), ": cannot ", action, ": ", std::strerror(error)));
}

FileDescriptor::FileDescriptor(const fs::path& path, int flags)
    : fd_(Fails("open", (flags & O_CREAT) != 0 ? ENOSPC : EIO)
              ? -1
              : ::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}

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
    const ssize_t written = TransferOnce(
        "write",
        [&](std::size_t count) {
          return ::pwrite(to.get(), bytes.data(), count, static_cast<off_t>(offset));
        },
        bytes.size(), ENOSPC);
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
    const ssize_t read = TransferOnce(
        "read",
        [&](std::size_t part) {
          return ::pread(from.get(), bytes + done, part, static_cast<off_t>(offset + done));
        },
        count - done, EIO);
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) return -1;
    if (read == 0) break;
    done += static_cast<std::size_t>(read);
  }
  return static_cast<std::ptrdiff_t>(done);
}

int SyncFile(const FileDescriptor& file) {
  return Fails("sync", ENOSPC) ? -1 : ::fsync(file.get());
}

int RenameFile(const fs::path& from, const fs::path& to) {
  return Fails("rename", ENOSPC) ? -1 : ::rename(from.c_str(), to.c_str());
}

}  // namespace cvo
