// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/files/disk.h"

namespace cvo {

// Bytes that are needed again at the end of a long job: a few of them in memory, all before in a
// file without a name, which goes away with the process. All throw Error where it cannot be written
// or read.
class Spool {
 public:
  static constexpr std::size_t kInMemory = std::size_t{1} << 14U;

  // `folder`: where the file is, once there are more than kInMemory bytes; empty: all of them stay
  // in memory.
  explicit Spool(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}

  std::uint64_t size() const { return in_file_ + tail_.size(); }
  void Append(std::string_view bytes);
  // `size` bytes from one on that was appended.
  std::string Read(std::uint64_t begin, std::size_t size) const;

 private:
  void Open();

  std::filesystem::path folder_;
  std::filesystem::path name_;  // in messages
  FileDescriptor file_;
  std::uint64_t in_file_ = 0;
  std::string tail_;  // of the bytes: those that are not in the file
};

}  // namespace cvo
