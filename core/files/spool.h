// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/files/disk.h"

namespace cvo {

// An append-only buffer for a long job. The most recent bytes are in memory, all earlier ones in an
// unlinked temporary file that disappears with the process. All functions throw Error if the file
// cannot be written or read.
class Spool {
 public:
  static constexpr std::size_t kInMemory = std::size_t{1} << 14U;

  // `folder` is for the file, which is created once there are kInMemory bytes. If `folder` is
  // empty, all bytes stay in memory.
  explicit Spool(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}

  std::uint64_t size() const { return in_file_ + tail_.size(); }
  void Append(std::string_view bytes);
  // Reads `size` bytes from `begin` on. Throws Error if they were never appended.
  std::string Read(std::uint64_t begin, std::size_t size) const;

 private:
  void Open();

  std::filesystem::path folder_;
  std::filesystem::path name_;  // for messages
  FileDescriptor file_;
  std::uint64_t in_file_ = 0;
  std::string tail_;  // bytes that are not in the file yet
};

}  // namespace cvo
