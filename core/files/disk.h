// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

// The calls of the operating system that results and caches rest on, in one place so that a test
// can make each fail. With CLUSTERVO_FAULT=<kind>,<n>,<file> in the environment, the n-th call
// (from 1) of all processes that count in that file of 8 bytes does: "fail" (no space; of a read:
// an I/O error), "short" (half of the bytes are written or read) or "kill" (the process ends before
// it).
namespace cvo {

// Throws Error "<file>: cannot <action>: <the system's reason>".
[[noreturn]] void ThrowErrno(const std::filesystem::path& file, const char* action, int error);

// An open file. get() is negative where it could not be opened; errno then says why.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  FileDescriptor(const std::filesystem::path& path, int flags);
  ~FileDescriptor();
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;

  int get() const { return fd_; }
  // Some file systems report a failed write only here: zero, or negative with errno.
  int Close();

 private:
  int fd_ = -1;
};

// Writes all bytes from an offset on. Throws Error naming `file`.
void WriteAll(const FileDescriptor& to, std::string_view bytes, std::uint64_t offset,
              const std::filesystem::path& file);
// At most `count` bytes from an offset on: fewer only where the file ends. Negative with errno
// where it cannot be read.
std::ptrdiff_t ReadUpTo(const FileDescriptor& from, char* bytes, std::size_t count,
                        std::uint64_t offset);
// Zero, or negative with errno.
int SyncFile(const FileDescriptor& file);
int RenameFile(const std::filesystem::path& from, const std::filesystem::path& to);
int LinkFile(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace cvo
