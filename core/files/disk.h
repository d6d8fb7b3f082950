// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

// The system calls that results and caches depend on, in one place so that a test can make each of
// them fail. With CLUSTERVO_FAULT=<fault>,<call>,<n>,<file> in the environment, the n-th call (from
// 1) of a kind ("open", "read", "write", "sync", "rename", "link") has a fault. Calls are counted
// over all processes that share <file>, a counter of 8 bytes. A fault is "fail" (no space; an I/O
// error for a read), "short" (half of the bytes are written or read) or "kill" (of the process).
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
// Each returns zero, or a negative value with errno set.
int SyncFile(const FileDescriptor& file);
int RenameFile(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace cvo
