// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Preloaded into the program by disk_test.cc: system calls that fail, transfer half of their bytes,
// or kill the process. DISK_FAULT=<fault>,<call>,<n>,<folder>/<counter>: the n-th call (from 1) of
// a kind on files of the folder, over all processes that share the counter of 8 bytes.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

template <typename Call>
Call Real(const char* name, const Call& /*type*/) {
  return reinterpret_cast<Call>(::dlsym(RTLD_NEXT, name));
}

struct Fault {
  std::array<char, 16> kind{};
  std::array<char, 16> call{};
  std::uint64_t number = 0;
  std::string folder;
  std::uint64_t* calls = nullptr;
};

Fault FromEnvironment() {
  Fault fault;
  unsigned long long number = 0;
  int name = 0;
  const char* text = std::getenv("DISK_FAULT");
  std::sscanf(text, "%15[^,],%15[^,],%llu,%n", fault.kind.data(), fault.call.data(), &number,
              &name);
  fault.number = number;
  fault.folder = text + name;
  const int fd = Real("open", &::open)(fault.folder.c_str(), O_RDWR | O_CLOEXEC);
  fault.calls = static_cast<std::uint64_t*>(
      ::mmap(nullptr, sizeof(std::uint64_t), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0));
  fault.folder.resize(fault.folder.rfind('/'));
  return fault;
}

// The first letter of the fault that this call has; 0: none.
char FaultOf(const std::string& call, const std::string& path) {
  static const Fault fault = FromEnvironment();
  if (call != fault.call.data() || !path.starts_with(fault.folder)) return 0;
  if (std::atomic_ref(*fault.calls).fetch_add(1) + 1 != fault.number) return 0;
  if (fault.kind[0] == 'k') ::raise(SIGKILL);
  return fault.kind[0];
}

std::string PathOf(int fd) {
  std::array<char, 4096> path{};
  const std::string link = "/proc/self/fd/" + std::to_string(fd);
  return ::readlink(link.c_str(), path.data(), path.size() - 1) > 0 ? path.data() : "";
}

template <typename Result, typename Call>
Result Once(char fault, int error, std::size_t count, const Call& call) {
  if (fault != 'f') return call(fault == 's' ? (count + 1) / 2 : count);
  errno = error;
  return -1;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const auto mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  const int error = (flags & O_CREAT) != 0 ? ENOSPC : EIO;
  return Once<int>(FaultOf("open", path), error, 0,
                   [&](std::size_t) { return Real("open", &::open)(path, flags, mode); });
}

ssize_t pwrite(int fd, const void* bytes, std::size_t count, off_t offset) {
  return Once<ssize_t>(FaultOf("write", PathOf(fd)), ENOSPC, count, [&](std::size_t part) {
    return Real("pwrite", &::pwrite)(fd, bytes, part, offset);
  });
}

ssize_t pread(int fd, void* bytes, std::size_t count, off_t offset) {
  return Once<ssize_t>(FaultOf("read", PathOf(fd)), EIO, count, [&](std::size_t part) {
    return Real("pread", &::pread)(fd, bytes, part, offset);
  });
}

// What pread is where the compiler checks the size of buffers.
ssize_t __pread_chk(int fd, void* bytes, std::size_t count, off_t offset, std::size_t /*size*/) {
  return pread(fd, bytes, count, offset);
}

int fsync(int fd) {
  return Once<int>(FaultOf("sync", PathOf(fd)), ENOSPC, 0,
                   [&](std::size_t) { return Real("fsync", &::fsync)(fd); });
}

int rename(const char* from, const char* to) noexcept {
  return Once<int>(FaultOf("rename", to), ENOSPC, 0,
                   [&](std::size_t) { return Real("rename", &::rename)(from, to); });
}

}  // extern "C"
