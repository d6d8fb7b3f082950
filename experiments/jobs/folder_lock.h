// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace cvo {

// The exclusive right to write to a suite's folder, held while this object exists and the process
// lives. Others may read meanwhile.
class FolderLock {
 public:
  // Throws Error saying which process on which host holds the lock, or why the file cannot be
  // created.
  explicit FolderLock(const std::filesystem::path& file);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_;
};

}  // namespace cvo
