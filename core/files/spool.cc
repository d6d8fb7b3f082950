// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/spool.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "core/base/error.h"
#include "core/files/temporary.h"

namespace cvo {

void Spool::Append(std::string_view bytes) {
  tail_ += bytes;
  if (folder_.empty() || tail_.size() < kInMemory) return;
  if (file_.get() < 0) Open();
  WriteAll(file_, tail_, in_file_, name_);
  in_file_ += tail_.size();
  tail_.clear();
}

std::string Spool::Read(std::uint64_t begin, std::size_t size) const {
  Require(begin + size <= this->size(), "Spool: bytes that were never appended");
  std::string bytes(begin < in_file_ ? std::min<std::uint64_t>(size, in_file_ - begin) : 0, '\0');
  if (!bytes.empty()) {
    const auto read = ReadUpTo(file_, bytes.data(), bytes.size(), begin);
    if (read < 0) ThrowErrno(name_, "read", errno);
    Require(static_cast<std::size_t>(read) == bytes.size(), "Spool: the file became shorter");
  }
  const std::uint64_t rest = size - bytes.size();
  if (rest > 0) bytes.append(tail_, begin + bytes.size() - in_file_, rest);
  return bytes;
}

void Spool::Open() {
  // A killed process with the same id may have left such files behind.
  for (int attempt = 0;; ++attempt) {
    name_ = TemporaryName(folder_ / "spool", std::to_string(attempt));
    file_ = FileDescriptor(name_, O_RDWR | O_CREAT | O_EXCL);
    if (file_.get() >= 0) break;
    if (errno != EEXIST || attempt == 1000) ThrowErrno(name_, "write", errno);
  }
  ::unlink(name_.c_str());
}

}  // namespace cvo
